// Air on a grid, moved by jets and fans: what blows on films.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "language/variables.h"
#include "scene/forces.h"

namespace lamella::air {

using film::Vec3;

// Incompressible flow after J. Stam, "Stable fluids", SIGGRAPH 99: fans push and jets prescribe, velocities
// are carried along by themselves (semi-Lagrangian, so that no step is too long), and Fourier transforms take
// out what is not free of divergence and damp by viscosity. The box repeats itself; there are no obstacles.
class AirFlow {
 public:
  AirFlow(const scene::Air& air, const language::Variables& variables);
  ~AirFlow();
  AirFlow(AirFlow&&) noexcept;
  AirFlow& operator=(AirFlow&&) noexcept;

  // Moves the air on until it is less than one of its own steps behind `time`. Its step is half the time in
  // which it, or anything at speed 1 if that is faster, crosses a cell.
  void advance(double time);

  // Velocity at a point, linear between the middles of the cells.
  Vec3 at(const Vec3& point) const;
  double pressure() const;

  // State and time, for the scene to keep.
  void store(scene::Air& air) const;

 private:
  struct Work;
  std::unique_ptr<Work> work_;
};

}  // namespace lamella::air
