#include "evolution/motion.h"

#include <algorithm>
#include <cmath>

#include "evolution/masses.h"

namespace lamella::evolution {

namespace {

using solve::Ending;

constexpr int most_volume_passes = 8;
constexpr double volume_tolerance = 1e-12;  // relative
// The volumes need no second look after a pass that leaves less than this by its expected rate.
constexpr double most_left_unseen = 2e-12;
// A step may raise the total energy by this part of it before it counts as a failure: a symplectic step below
// the bound wobbles by far less, an unstable one grows without limit.
constexpr double most_energy_rise = 0.02;

}  // namespace

Motion::Motion(scene::Scene& scene)
    : scene_(scene),
      terms_(scene),
      gram_(terms_.volume_gradient().rows(), terms_.volume_gradient().pattern()),
      gram_values_(terms_.volume_gradient().pattern().size()),
      weights_(scene.film.vertex_rows()),
      x_(scene.film.positions().begin(), scene.film.positions().end()),
      v_(velocities(scene.film)),
      next_x_(x_.size()),
      next_v_(x_.size()),
      errors_(terms_.constrained().size()),
      multipliers_(errors_.size()),
      next_pressures_(errors_.size()) {
  for (const film::Region region : terms_.constrained()) pressures_.push_back(scene.body(region).pressure);
  energy_ = terms_.gradient(x_);
  masses_ = carried_masses(scene.film, terms_.lines());
  const auto fixed = scene.film.columns(film::ElementKind::vertex).flags("fixed");
  for (std::size_t v = 0; v < x_.size(); ++v) {
    const bool stays = masses_[v] <= 0 || (!fixed.empty() && fixed[v] != 0);
    weights_[v] = stays ? 0 : 1 / masses_[v];
    if (stays) v_[v] = {};
    kinetic_ += 0.5 * masses_[v] * squared_length(v_[v]);
  }
  sound_ = linearise();
}

// After terms_.gradient: the bound, and the factors for the volume constraints.
bool Motion::linearise() {
  const std::span<const energy::VertexLine> lines = terms_.lines();
  double stiffest = 0;
  for (std::size_t v = 0; v < weights_.size(); ++v)
    stiffest = std::max(stiffest, lines[v].stiffness * weights_[v]);
  bound_ = stiffest > 0 ? 2 / std::sqrt(stiffest) : HUGE_VAL;
  if (!std::isfinite(energy_)) return false;
  if (errors_.empty()) return true;
  terms_.volume_gradient().gram(weights_, gram_values_);
  return gram_.factorise(gram_values_);
}

void Motion::kick_and_drift(double dt) {
  const std::span<const energy::VertexLine> lines = terms_.lines();
  energy::VolumeGradient& volume = terms_.volume_gradient();
  volume.set_multipliers(pressures_);
  const bool free = errors_.empty();
  const double kept = std::exp(-scene_.damping * dt);
  next_kinetic_ = 0;
  for (std::size_t v = 0; v < x_.size(); ++v) {
    const Vec3 force = free ? -lines[v].gradient : volume.pull(v) - lines[v].gradient;
    next_v_[v] = kept * (v_[v] + (dt * weights_[v]) * force);
    next_x_[v] = x_[v] + dt * next_v_[v];
    next_kinetic_ += 0.5 * masses_[v] * squared_length(next_v_[v]);
  }
}

// Puts held vertices onto their constraints at the end of the step; what that moves them is velocity, too.
bool Motion::keep_constraints(double dt) {
  energy::VertexConstraints& constraints = terms_.constraints();
  if (constraints.empty()) return true;
  if (!constraints.project(next_x_)) return false;
  constraints.for_each([&](std::uint32_t v) {
    next_kinetic_ -= 0.5 * masses_[v] * squared_length(next_v_[v]);
    next_v_[v] = (next_x_[v] - x_[v]) / dt;
    next_kinetic_ += 0.5 * masses_[v] * squared_length(next_v_[v]);
  });
  return true;
}

// Adds the impulse of the multipliers along the volume gradients at the start of the step.
void Motion::correct(double dt) {
  energy::VolumeGradient& volume = terms_.volume_gradient();
  volume.set_multipliers(multipliers_);
  next_kinetic_ = 0;
  for (std::size_t v = 0; v < x_.size(); ++v) {
    const Vec3 shift = weights_[v] * volume.pull(v);
    next_x_[v] += shift;
    next_v_[v] += shift / dt;
    next_kinetic_ += 0.5 * masses_[v] * squared_length(next_v_[v]);
  }
  for (std::size_t i = 0; i < errors_.size(); ++i) next_pressures_[i] += multipliers_[i] / (dt * dt);
}

bool Motion::keep_volumes(double dt) {
  next_pressures_ = pressures_;
  double before = 0;
  for (int pass = 0; pass < most_volume_passes; ++pass) {
    terms_.value(next_x_);
    double worst = 0;
    for (std::size_t i = 0; i < errors_.size(); ++i) {
      const film::Region region = terms_.constrained()[i];
      const double target = scene::target_at(scene_.body(region), scene_.time + dt);
      errors_[i] = target - terms_.volumes()[region.index];
      worst = std::max(worst, std::abs(errors_[i] / target));
    }
    if (!std::isfinite(worst)) return false;
    if (worst < volume_tolerance) return true;
    gram_.solve(errors_, multipliers_);
    correct(dt);
    if (before > 0) pass_rate_ = worst / before;
    if (worst * pass_rate_ < most_left_unseen) return true;
    before = worst;
  }
  return false;
}

// Blowing up a body by a moving target puts energy in, as do constraints that move; otherwise only forces of
// the scene's own energy act.
bool Motion::rises_from_nowhere(double energy, double kinetic) const {
  if (terms_.constraints().moves()) return false;
  const bool inflating = std::any_of(scene_.bodies.begin(), scene_.bodies.end(),
                                     [](const scene::Body& body) { return body.ramp.has_value(); });
  const double before = energy_ + kinetic_;
  return !inflating && energy + kinetic > before + most_energy_rise * std::abs(before);
}

// Back to the start of the step, whose linearisation trials have overwritten.
Ending Motion::undo(Ending why) {
  terms_.set_time(scene_.time);
  energy_ = terms_.gradient(x_);
  sound_ = linearise();
  return why;
}

Ending Motion::step(double dt) {
  if (!sound_) return std::isfinite(energy_) ? Ending::volume_lost : Ending::not_finite;
  kick_and_drift(dt);
  terms_.set_time(scene_.time + dt);
  if (!keep_constraints(dt)) return undo(Ending::constraint_lost);
  if (!errors_.empty() && !keep_volumes(dt)) return undo(Ending::volume_lost);
  const double energy = terms_.gradient(next_x_);
  const bool finite = std::isfinite(energy + next_kinetic_);
  if (!finite) return undo(Ending::not_finite);
  if (rises_from_nowhere(energy, next_kinetic_)) return undo(Ending::stuck);
  std::swap(x_, next_x_);
  std::swap(v_, next_v_);
  std::swap(pressures_, next_pressures_);
  energy_ = energy;
  kinetic_ = next_kinetic_;
  scene_.time += dt;
  scene::advance_targets(scene_, scene_.time);
  for (std::size_t i = 0; i < pressures_.size(); ++i)
    scene_.body(terms_.constrained()[i]).pressure = pressures_[i];
  sound_ = linearise();
  return Ending::step_limit;
}

double Motion::volume_error() const {
  double worst = 0;
  for (const film::Region region : terms_.constrained()) {
    const double target = *scene_.body(region).target_volume;
    worst = std::max(worst, std::abs(terms_.volumes()[region.index] / target - 1));
  }
  return worst;
}

void Motion::store() {
  std::copy(x_.begin(), x_.end(), scene_.film.edit_positions().begin());
  store_motion(scene_.film, masses_, v_);
}

}  // namespace lamella::evolution
