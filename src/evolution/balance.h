// What a moving film as a whole has: mass, kinetic energy, momentum.
#pragma once

#include <span>

#include "film/vec3.h"
#include "scene/scene.h"

namespace lamella::evolution {

using film::Vec3;

struct Balance {
  double mass = 0;
  double kinetic = 0;     // sum of m v^2 / 2
  Vec3 momentum;          // sum of m v
  Vec3 angular_momentum;  // sum of m x cross v, about the origin
};

// One row a vertex.
Balance balance(std::span<const Vec3> positions, std::span<const Vec3> velocities,
                std::span<const double> masses);

// Of a scene: masses and velocities are its vertices' columns, which evolve keeps. A film that has never
// moved has neither.
Balance balance(const scene::Scene& scene);

}  // namespace lamella::evolution
