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

void advance_targets(Scene& scene, double time) {
  for (Body& body : scene.bodies) {
    if (!body.ramp) continue;
    const VolumeRamp& r = *body.ramp;
    const double part = r.end > r.begin ? std::clamp((time - r.begin) / (r.end - r.begin), 0.0, 1.0) : 1.0;
    body.target_volume = r.from + part * (r.to - r.from);
    if (time >= r.end) {
      body.target_volume = r.to;
      body.ramp.reset();
    }
  }
}

double tension(const Scene& scene, film::Triangle t) {
  const auto tensions = scene.film.columns(film::ElementKind::facet).reals("tension");
  return tensions.empty() ? 1.0 : tensions[t.index];
}

}  // namespace lamella::scene
