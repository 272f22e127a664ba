// The accelerations that the scene's forces give to the vertices of a moving film.
#pragma once

#include <span>
#include <vector>

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

 private:
  film::Film film_;  // for the normals of films with one region on both sides
  scene::Forces forces_;
  bool needs_normals_ = false;
  std::vector<Vec3> area_vectors_;
};

}  // namespace lamella::evolution
