#include "evolution/rigid_velocity.h"

#include <algorithm>

#include "film/mat3.h"

namespace lamella::evolution {

namespace {

constexpr double least_determinant = 1e-12;  // of the inertia, in cubes of its trace

}  // namespace

Kept kept_by(const scene::Scene& scene) {
  const auto fixed = scene.film.columns(film::ElementKind::vertex).flags("fixed");
  const bool free = std::none_of(fixed.begin(), fixed.end(), [](auto flag) { return flag != 0; }) &&
                    scene.level_sets.empty() && scene.boundaries.empty();
  if (!free) return Kept::none;
  return scene.film.periodic() ? Kept::momentum : Kept::both_momenta;
}

RigidVelocity rigid_velocity(const Balance& whole, std::span<const Vec3> x, std::span<const double> masses,
                             Kept kept) {
  RigidVelocity motion;
  for (std::size_t v = 0; v < x.size(); ++v) motion.centre += (masses[v] / whole.mass) * x[v];
  motion.velocity = whole.momentum / whole.mass;
  if (kept != Kept::both_momenta) return motion;
  const Vec3 about = whole.angular_momentum - cross(motion.centre, whole.momentum);
  film::Mat3 inertia;
  for (std::size_t v = 0; v < x.size(); ++v) {
    const Vec3 r = x[v] - motion.centre;
    inertia += masses[v] * (squared_length(r) * film::identity3() - film::outer(r, r));
  }
  const double trace = inertia.x.x + inertia.y.y + inertia.z.z;
  const Vec3 yz = cross(inertia.y, inertia.z);
  const double determinant = dot(inertia.x, yz);
  // What has no breadth does not turn.
  if (!(determinant > least_determinant * trace * trace * trace)) return motion;
  motion.turn =
      (about.x * yz + about.y * cross(inertia.z, inertia.x) + about.z * cross(inertia.x, inertia.y)) /
      determinant;
  return motion;
}

}  // namespace lamella::evolution
