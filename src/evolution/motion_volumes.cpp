// How a step of Motion keeps volumes.
#include <algorithm>
#include <cmath>

#include "evolution/masses.h"
#include "evolution/motion.h"
#include "evolution/rigid_velocity.h"
#include "evolution/swept_places.h"
#include "film/blocks.h"

namespace lamella::evolution {

namespace {

constexpr int most_volume_passes = 8;
constexpr double volume_tolerance = 1e-12;  // relative
// The volumes need no second look after a pass that leaves less than this by its expected rate; rates vary
// from step to step. Where the sweep at the end of the step tells, and it may be made again, more is risked.
constexpr double most_left_unseen = 2e-12 / 30;
constexpr double most_left_to_the_sweep = 1.0 / 6;  // in parts of what may be missed
// Where systems are solved by iteration: relative, and as parts of what the next pass finds anyway.
constexpr double solved_to = 2e-13;
constexpr double part_of_next = 0.03;
constexpr double part_of_missed = 1e-3;  // of what may be missed
// A step that has missed volumes by more than this is made again, with a look; one that follows a step that
// has missed them by a part of that is looked at from the start. Where what is missed is made good before
// anybody looks, it is the forces that are to be taken near enough to the film that is shown; else volumes
// are as far off as this says.
constexpr double missed_much = 1e-10;
constexpr double missed_much_unseen = 5e-5;
constexpr double missed_little = 0.2;

}  // namespace

// Whether what steps leave of the volumes may wait until someone looks. Where constraints hold vertices it
// may not: projections go on from where the last one ended, so that a look would change the path.
bool Motion::settles() const {
  return volume_mode_ == VolumeMode::automatic && !is_implicit(method_) && !errors_.empty() &&
         terms_.constraints().empty();
}

double Motion::most_missed() const {
  return settles() ? missed_much_unseen : missed_much;
}

// The film put along the gradients at x_ until its volumes are right.
const Motion::Vectors& Motion::settled() {
  if (!settles() || !sound_) return x_;
  if (is_settled_) return settled_;
  is_settled_ = true;
  settled_ = x_;
  settled_error_ = compare(present_, scene_.time);
  for (int pass = 0; pass < most_volume_passes && settled_error_ > volume_tolerance; ++pass) {
    const double left = part_of_next * settled_error_ * settled_error_;
    gram_.solve(errors_, multipliers_, std::max(solved_to, left) * smallest_target());
    energy::VolumeGradient& volume = terms_.volume_gradient();
    volume.set_multipliers(multipliers_);
    film::for_each_block(x_.size(), [&](std::size_t first, std::size_t last) {
      for (std::size_t v = first; v < last; ++v) settled_[v] += answers_[v] * volume.pull(v);
    });
    const double before = settled_error_;
    settled_error_ = look_at_volumes(settled_, scene_.time);
    if (settled_error_ > 0.5 * before) break;
  }
  return settled_;
}

double Motion::volume_error() {
  settled();
  return settles() && sound_ ? settled_error_ : compare(present_, scene_.time);
}

// What settling turns the film by is given back to the velocities of a film that nothing holds.
Motion::Vectors Motion::velocities_when_settled() {
  const Vectors& places = settled();
  Vectors result = v_;
  if (&places == &x_ || !is_loose()) return result;
  const Balance before = evolution::balance(x_, v_, masses_);
  Balance missing;
  missing.mass = before.mass;
  missing.angular_momentum =
      before.angular_momentum - evolution::balance(places, v_, masses_).angular_momentum;
  const RigidVelocity shift = rigid_velocity(missing, places, masses_, kept_by(scene_));
  for (std::size_t v = 0; v < result.size(); ++v) result[v] += shift.at(places[v]);
  return result;
}

void Motion::leave() {
  store();
  if (!settles() || !sound_) return;
  store_velocities(scene_.film, v_);
  store_swept_places(scene_, x_);
}

void Motion::take_up_swept_places() {
  const std::optional<std::vector<Vec3>> places = take_swept_places(scene_);
  if (places && settles()) std::ranges::copy(*places, x_.begin());
}

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
  const double least = settles() ? part_of_missed * missed_much_unseen : solved_to;
  const double looked_for =
      std::isfinite(memory_.miss()) ? std::max(least, part_of_next * memory_.miss()) : least;
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

// What volumes lack at a time, and the largest part of one that is missing.
double Motion::compare(std::span<const double> volumes, double time) {
  double worst = 0;
  for (std::size_t i = 0; i < errors_.size(); ++i) {
    const double wanted = target(i, time);
    errors_[i] = wanted - volumes[i];
    const double part = std::abs(errors_[i] / wanted);
    worst = std::isfinite(part) ? std::max(worst, part) : HUGE_VAL;
  }
  return worst;
}

// The same of the volumes at these positions.
double Motion::look_at_volumes(std::span<const Vec3> positions, double time) {
  terms_.value(positions);
  return compare(terms_.held_values(), time);
}

bool Motion::goes_in_one_pass() const {
  if (is_implicit(method_)) return false;
  return volume_mode_ == VolumeMode::lagged ||
         (volume_mode_ == VolumeMode::automatic && memory_.miss() < missed_little * most_missed());
}

bool Motion::keep_volumes(double dt) {
  if (volume_mode_ == VolumeMode::paper) return correct_as_paper(dt);
  relies_on_sweep_ = false;
  if (one_pass_) return true;
  relies_on_sweep_ = volume_mode_ == VolumeMode::automatic && !distrusts_rate_ && !is_implicit(method_);
  const double unseen = relies_on_sweep_ ? most_left_to_the_sweep * most_missed() : most_left_unseen;
  double before = 0;
  for (int pass = 0; pass < most_volume_passes; ++pass) {
    const double worst = look_at_volumes(next_x_, scene_.time + dt);
    if (!std::isfinite(worst)) return false;
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
  if (!std::isfinite(look_at_volumes(next_x_, scene_.time + dt))) return false;
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
    if (!(std::abs(missed) < most_missed() * std::abs(wanted))) return true;
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
