#include "evolution/retreat.h"

#include <algorithm>
#include <cmath>

namespace lamella::evolution {

namespace {

constexpr int most_attempts = 9;
constexpr int attempts_free = 1;  // with shorter steps alone
constexpr double least_part = 0.05;
// What is held is let go after so many moments at which the film was sound.
constexpr int most_looks_held = 3;

}  // namespace

bool Retreat::ready() {
  if (safe_ && known_ == Known::unknown) {
    if (surgery::tangles(safe_->film).empty())
      known_ = Known::sound;
    else
      safe_.reset();
  }
  return safe_.has_value();
}

void Retreat::remember(const scene::Scene& scene, Known known) {
  const bool same_mesh = safe_ && safe_->film.connectivity_revision() == scene.film.connectivity_revision();
  safe_ = scene;
  known_ = known;
  attempts_ = 0;
  part_ = std::min(1.0, 2 * part_);
  if (!same_mesh || ++looks_held_ > most_looks_held) held_.clear();
}

bool Retreat::go_back(scene::Scene& scene, const std::vector<surgery::Tangle>& tangles) {
  scene = *safe_;
  if (++attempts_ > most_attempts) return false;
  part_ = std::max(least_part, std::ldexp(1.0, -attempts_));
  looks_held_ = 0;
  if (attempts_ <= attempts_free) return true;
  std::vector<surgery::Tangle> all = held_;
  for (const surgery::Tangle& tangle : tangles)
    all.push_back(surgery::grown(scene.film, tangle, attempts_ - attempts_free - 1));
  held_ = surgery::united(scene.film, all);
  return true;
}

}  // namespace lamella::evolution
