#include "evolution/balance.h"

#include "evolution/masses.h"

namespace lamella::evolution {

Balance balance(std::span<const Vec3> positions, std::span<const Vec3> velocities,
                std::span<const double> masses) {
  Balance sum;
  for (std::size_t v = 0; v < positions.size(); ++v) {
    const Vec3 momentum = masses[v] * velocities[v];
    sum.mass += masses[v];
    sum.kinetic += 0.5 * dot(momentum, velocities[v]);
    sum.momentum += momentum;
    sum.angular_momentum += cross(positions[v], momentum);
  }
  return sum;
}

Balance balance(const scene::Scene& scene) {
  const std::span<const double> masses = scene.film.columns(film::ElementKind::vertex).reals("mass");
  if (masses.empty()) return {};
  return balance(scene.film.positions(), velocities(scene.film), masses);
}

}  // namespace lamella::evolution
