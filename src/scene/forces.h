// What acts on a film in motion besides its energy.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "film/vec3.h"
#include "language/formula.h"

namespace lamella::scene {

// A vector at each vertex: formulas in x, y, z, total_time, the scene's variables, the vertex's velocity vx,
// vy, vz, and its unit normal nx, ny, nz (out of the region of higher number, so out of a bubble; in films
// with one region on both sides its sign is arbitrary). They are to be bound (language::Formula::bind) before
// use.
struct VectorFormula {
  std::array<language::Formula, 3> component;
  std::string text() const {
    return component[0].text() + ", " + component[1].text() + ", " + component[2].text();
  }
};

// The names that VectorFormula reads besides coordinates and time, in this order.
inline const std::vector<std::string> vertex_state_names = {"vx", "vy", "vz", "nx", "ny", "nz"};

// A box of moving air on a grid that repeats in all directions (src/air). Fans and jets are formulas in x, y,
// z, total_time and the scene's variables.
struct Air {
  int cells = 32;  // along each axis
  film::Vec3 from{-2, -2, -2};
  film::Vec3 to{2, 2, 2};
  std::optional<VectorFormula> fan;  // force per mass of air
  std::optional<VectorFormula> jet;  // velocity that the air is given wherever this is not zero
  double viscosity = 0;              // area per time
  double pressure = 1;               // as `wind_pressure`
  // One a cell, x fastest, at the middle of the cells; absent while the air has not moved. `time` is when.
  std::shared_ptr<const std::vector<film::Vec3>> velocity;
  double time = 0;
};

struct Forces {
  // Force per area of film: the acceleration, as the film's mass is its area.
  std::optional<VectorFormula> force;
  // Velocity of the air. It pushes the film along its normal: force per area = pressure (u.n) n with u the
  // air's velocity relative to the film; of bubbles only where the wind comes from outside.
  std::optional<VectorFormula> wind;
  double wind_pressure = 1;
  std::optional<Air> air;

  bool empty() const { return !force && !wind && !air; }
};

}  // namespace lamella::scene
