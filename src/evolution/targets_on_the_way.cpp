#include "evolution/targets_on_the_way.h"

#include <algorithm>
#include <cmath>

#include "energy/film_energy.h"
#include "energy/measure.h"

namespace lamella::evolution {

namespace {

// A volume grows or shrinks by this factor at most.
constexpr double longest_stride = 2;

}  // namespace

double missing_volume(const scene::Scene& scene) {
  if (!scene.has_fixed_volume()) return 0;
  const energy::Measures now = energy::measure(scene);
  double worst = 0;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    if (!scene.bodies[b].fixed_volume()) continue;
    const double target = *scene.bodies[b].target_volume;
    const double part = std::abs(now.volumes[b + 1] - target) / std::abs(target);
    worst = std::isfinite(part) ? std::max(worst, part) : HUGE_VAL;
  }
  return worst;
}

TargetsOnTheWay::TargetsOnTheWay(scene::Scene& scene) : scene_(scene) {
  for (std::uint32_t b = 0; b < scene.bodies.size(); ++b) {
    if (!scene.bodies[b].fixed_volume()) continue;
    bodies_.push_back(film::Region(b + 1));
    wanted_.push_back(*scene.bodies[b].target_volume);
  }
}

TargetsOnTheWay::~TargetsOnTheWay() {
  for (std::size_t i = 0; i < bodies_.size(); ++i) scene_.body(bodies_[i]).target_volume = wanted_[i];
}

bool TargetsOnTheWay::stride() {
  for (std::size_t i = 0; i < bodies_.size(); ++i) scene_.body(bodies_[i]).target_volume = wanted_[i];
  if (bodies_.empty() || scene_.film.periodic()) return false;
  energy::FilmEnergy terms(scene_);
  terms.value(scene_.film.positions());
  bool far = false;
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    const double here = terms.volumes()[bodies_[i].index];
    if (!(here * wanted_[i] > 0)) continue;
    const double factor = std::clamp(wanted_[i] / here, 1 / longest_stride, longest_stride);
    if (factor > 1 / longest_stride && factor < longest_stride) continue;
    scene_.body(bodies_[i]).target_volume = factor * here;
    far = true;
  }
  return far;
}

}  // namespace lamella::evolution
