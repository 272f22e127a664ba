// The accelerations that the scene's forces give to the vertices of a moving film.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "air/air_flow.h"
#include "energy/sweep.h"
#include "scene/scene.h"

namespace lamella::evolution {

using film::Vec3;

class ExternalForces {
 public:
  explicit ExternalForces(const scene::Scene& scene);

  // A scene without forces pays for this question only.
  bool empty() const { return forces_.empty(); }

  // Acceleration of every vertex at positions x and velocities v; `lines` from the sweep at x. False if one
  // of them is not finite.
  bool evaluate(std::span<const Vec3> x, std::span<const Vec3> v, std::span<const energy::VertexLine> lines,
                double time, std::span<Vec3> accelerations);

  // Lets the air flow on to a time.
  void advance(double time) {
    if (air_) air_->advance(time);
  }
  // The state of the air, for the scene to keep.
  void store(scene::Scene& scene) const {
    if (air_) air_->store(*scene.forces.air);
  }

 private:
  Vec3 blow(const Vec3& at, const language::FormulaInputs& inputs, const Vec3& velocity, const Vec3& normal,
            bool closed) const;

  film::Film film_;  // for the normals of films with one region on both sides
  scene::Forces forces_;
  std::optional<air::AirFlow> air_;
  bool needs_normals_ = false;
  std::vector<Vec3> area_vectors_;
};

}  // namespace lamella::evolution
