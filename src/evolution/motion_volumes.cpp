// How a step of Motion keeps volumes.
#include <algorithm>
#include <cmath>

#include "evolution/motion.h"
#include "film/blocks.h"

namespace lamella::evolution {

namespace {

constexpr int most_volume_passes = 8;
constexpr double volume_tolerance = 1e-12;  // relative
// The volumes need no second look after a pass that leaves less than this by its expected rate; rates vary
// from step to step. Where the sweep at the end of the step tells, and it may be made again, more is risked.
constexpr double most_left_unseen = 2e-12 / 30;
constexpr double most_left_to_the_sweep = 5e-11 / 3;
// Where systems are solved by iteration: relative, and as parts of what the next pass finds anyway.
constexpr double solved_to = 2e-13;
constexpr double part_of_next = 0.03;
// The next step goes without a look at its volumes if the last one missed them by less than this.
constexpr double missed_little = 2e-11;
// A step that has missed them by more is made again, with a look.
constexpr double missed_much = 1e-10;

}  // namespace

double Motion::target(std::size_t row, double time) const {
  return scene::target_at(scene_.body(terms_.constrained()[row]), time);
}

double Motion::smallest_target() const {
  double smallest = HUGE_VAL;
  for (std::size_t i = 0; i < errors_.size(); ++i)
    smallest = std::min(smallest, std::abs(target(i, scene_.time)));
  return smallest;
}

// What a multiplier of moves is divided by to be a pressure.
double Motion::pressure_span(double dt) const {
  if (method_ == Method::gradient) return dt;
  return method_ == Method::verlet ? 0.5 * dt * dt : dt * dt;
}

// The rates at which the kick that is to come will change volumes, from the products at x_; then what mends
// them.
void Motion::foresee_volumes(const Pace& pace) {
  terms_.volume_gradient().multiply_gram(products_.gram, pressures_, errors_);
  for (std::size_t i = 0; i < errors_.size(); ++i) {
    const double acceleration = products_.second[i] + errors_[i];
    errors_[i] = pace.kept * (pace.carried * products_.first[i] + pace.push * acceleration);
  }
  impose_volumes(pace.dt);
}

// Multipliers for velocities that bring the volumes to their targets in one step, as far as can be foreseen.
// `errors_` holds the rates at which volumes would change without them.
void Motion::impose_volumes(double dt) {
  for (std::size_t i = 0; i < errors_.size(); ++i) {
    foreseen_[i] = target(i, scene_.time + dt) - memory_.expected(i, dt);
    errors_[i] = (foreseen_[i] - present_[i]) / dt - errors_[i];
  }
  const double looked_for = std::isfinite(memory_.miss()) && memory_.miss() > missed_little
                                ? std::max(solved_to, part_of_next * memory_.miss())
                                : solved_to;
  gram_.solve(errors_, multipliers_, looked_for * smallest_target() / dt);
  for (std::size_t i = 0; i < multipliers_.size(); ++i)
    next_pressures_[i] += multipliers_[i] * dt / pressure_span(dt);
}

// Takes out of next_v_ what would change volumes other than as their targets do.
void Motion::project_velocities(double dt) {
  energy::VolumeGradient& volume = terms_.volume_gradient();
  volume.dot(ones_, next_v_, errors_);
  for (std::size_t i = 0; i < errors_.size(); ++i)
    errors_[i] = (target(i, scene_.time + dt) - target(i, scene_.time)) / dt - errors_[i];
  gram_.solve(errors_, multipliers_);
  volume.set_multipliers(multipliers_);
  next_kinetic_ = 0;
  for (std::size_t v = 0; v < x_.size(); ++v) {
    next_v_[v] += answers_[v] * volume.pull(v);
    next_kinetic_ += 0.5 * masses_[v] * squared_length(next_v_[v]);
  }
}

// Adds the impulse of the multipliers along the volume gradients at the start of the step.
void Motion::correct(double dt) {
  energy::VolumeGradient& volume = terms_.volume_gradient();
  volume.set_multipliers(multipliers_);
  next_kinetic_ = film::sum_of_blocks(x_.size(), [&](std::size_t first, std::size_t last) {
    double kinetic = 0;
    for (std::size_t v = first; v < last; ++v) {
      const Vec3 shift = answers_[v] * volume.pull(v);
      next_x_[v] += shift;
      next_v_[v] += shift / dt;
      kinetic += 0.5 * masses_[v] * squared_length(next_v_[v]);
    }
    return kinetic;
  });
  for (std::size_t i = 0; i < errors_.size(); ++i) next_pressures_[i] += multipliers_[i] / pressure_span(dt);
}

// Measures volumes at next_x_ and what they lack; false if they are not finite.
bool Motion::look_at_volumes(double dt, double& worst) {
  terms_.value(next_x_);
  worst = 0;
  for (std::size_t i = 0; i < errors_.size(); ++i) {
    const double wanted = target(i, scene_.time + dt);
    errors_[i] = wanted - terms_.volumes()[terms_.constrained()[i].index];
    worst = std::max(worst, std::abs(errors_[i] / wanted));
  }
  return std::isfinite(worst);
}

bool Motion::keep_volumes(double dt) {
  if (volume_mode_ == VolumeMode::paper) return correct_as_paper(dt);
  relies_on_sweep_ = false;
  one_pass_ =
      !is_implicit(method_) && (volume_mode_ == VolumeMode::lagged ||
                                (volume_mode_ == VolumeMode::automatic && memory_.miss() < missed_little));
  if (one_pass_) return true;
  relies_on_sweep_ = volume_mode_ == VolumeMode::automatic && !distrusts_rate_ && !is_implicit(method_);
  const double unseen = relies_on_sweep_ ? most_left_to_the_sweep : most_left_unseen;
  double before = 0;
  for (int pass = 0; pass < most_volume_passes; ++pass) {
    double worst = 0;
    if (!look_at_volumes(dt, worst)) return false;
    if (pass == 0) {
      for (std::size_t i = 0; i < errors_.size(); ++i) reached_[i] = target(i, scene_.time + dt) - errors_[i];
    }
    if (worst < volume_tolerance) return true;
    if (before > 0) memory_.note_rate(worst / before);
    const double left = worst * memory_.rate();
    gram_.solve(errors_, multipliers_, std::max(solved_to, part_of_next * left) * smallest_target());
    correct(dt);
    if (left < unseen) return true;
    before = worst;
  }
  return false;
}

bool Motion::correct_as_paper(double dt) {
  one_pass_ = true;
  double worst = 0;
  if (!look_at_volumes(dt, worst)) return false;
  std::vector<Vec3> moves(x_.size());
  if (!paper_->displacements(next_x_, errors_, multipliers_, moves)) return false;
  next_kinetic_ = 0;
  for (std::size_t v = 0; v < x_.size(); ++v) {
    if (weights_[v] != 0) {
      next_x_[v] += moves[v];
      next_v_[v] += moves[v] / dt;
    }
    next_kinetic_ += 0.5 * masses_[v] * squared_length(next_v_[v]);
  }
  for (std::size_t i = 0; i < errors_.size(); ++i) next_pressures_[i] = multipliers_[i] / pressure_span(dt);
  return true;
}

// After the sweep at the new positions: whether a volume is off by more than may be.
bool Motion::missed_too_far(double dt) const {
  if (volume_mode_ != VolumeMode::automatic) return false;
  for (std::size_t i = 0; i < present_.size(); ++i) {
    const double wanted = target(i, scene_.time + dt);
    const double missed = terms_.volumes()[terms_.constrained()[i].index] - wanted;
    if (!(std::abs(missed) < missed_much * std::abs(wanted))) return true;
  }
  return false;
}

// After the sweep at the new positions: what the step left beyond what was foreseen.
void Motion::remember_volumes(double dt) {
  for (std::size_t i = 0; i < present_.size(); ++i) {
    const double wanted = target(i, scene_.time + dt);
    present_[i] = terms_.volumes()[terms_.constrained()[i].index];
    const double reached = one_pass_ ? present_[i] : reached_[i];
    memory_.note(i, dt, reached - foreseen_[i], (reached - wanted) / wanted, std::abs(wanted));
  }
  memory_.finish();
}

}  // namespace lamella::evolution
