#include "scene/scene.h"

#include <algorithm>

namespace lamella::scene {

bool Scene::has_fixed_volume() const {
  return std::any_of(bodies.begin(), bodies.end(), [](const Body& b) { return b.fixed_volume(); });
}

std::uint32_t body_count(const Scene& scene) {
  return static_cast<std::uint32_t>(
      std::count_if(scene.bodies.begin(), scene.bodies.end(), [](const Body& b) { return !b.absent; }));
}

double target_at(const Body& body, double time) {
  if (!body.ramp) return *body.target_volume;
  const VolumeRamp& r = *body.ramp;
  if (time >= r.end) return r.to;
  return r.from + std::max(0.0, (time - r.begin) / (r.end - r.begin)) * (r.to - r.from);
}

void advance_targets(Scene& scene, double time) {
  for (Body& body : scene.bodies) {
    if (!body.ramp) continue;
    body.target_volume = target_at(body, time);
    if (time >= body.ramp->end) body.ramp.reset();
  }
}

std::uint32_t facet_count(const Scene& scene) {
  return scene.strings.on ? static_cast<std::uint32_t>(scene.strings.cells.size())
                          : scene.film.triangle_count();
}

double present_gravity(const Scene& scene) {
  return scene.gravity.on ? scene.gravity.constant : 0;
}

double tension(const Scene& scene, film::Triangle t) {
  const auto tensions = scene.film.columns(film::ElementKind::facet).reals("tension");
  return tensions.empty() ? 1.0 : tensions[t.index];
}

}  // namespace lamella::scene
