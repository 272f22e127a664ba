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

Motion::Motion(scene::Scene& scene, Method method)
    : scene_(scene),
      method_(method),
      terms_(scene),
      forces_(scene),
      gram_(terms_.volume_gradient().rows(), terms_.volume_gradient().pattern()),
      gram_values_(terms_.volume_gradient().pattern().size()),
      weights_(scene.film.vertex_rows()),
      x_(scene.film.positions().begin(), scene.film.positions().end()),
      v_(velocities(scene.film)),
      next_x_(x_.size()),
      next_v_(x_.size()),
      pushes_(forces_.empty() ? 0 : x_.size()),
      errors_(terms_.constrained().size()),
      multipliers_(errors_.size()),
      next_pressures_(errors_.size()) {
  for (const film::Region region : terms_.constrained()) pressures_.push_back(scene.body(region).pressure);
  energy_ = terms_.gradient(x_);
  masses_ = carried_masses(scene.film, terms_.lines());
  weigh();
  sound_ = linearise();
}

// Inverse masses and the kinetic energy that go with the masses.
void Motion::weigh() {
  const auto fixed = scene_.film.columns(film::ElementKind::vertex).flags("fixed");
  kinetic_ = mass_ = 0;
  for (std::size_t v = 0; v < x_.size(); ++v) {
    mass_ += masses_[v];
    const bool stays = masses_[v] <= 0 || (!fixed.empty() && fixed[v] != 0);
    weights_[v] = stays ? 0 : 1 / masses_[v];
    if (stays || method_ == Method::gradient) v_[v] = {};
    kinetic_ += 0.5 * masses_[v] * squared_length(v_[v]);
  }
}

// After terms_.gradient at x_: outer forces, the bound, and the factors for the volume constraints.
bool Motion::linearise() {
  const std::span<const energy::VertexLine> lines = terms_.lines();
  if (scene_.mass_of_area) {
    for (std::size_t v = 0; v < masses_.size(); ++v) masses_[v] = lines[v].area;
    weigh();
  }
  double stiffest = 0;
  for (std::size_t v = 0; v < weights_.size(); ++v)
    stiffest = std::max(stiffest, lines[v].stiffness * weights_[v]);
  const double rate = method_ == Method::gradient ? stiffest : std::sqrt(stiffest);
  bound_ = stiffest > 0 ? 2 / rate : HUGE_VAL;
  pushed_soundly_ = forces_.empty() || forces_.evaluate(x_, v_, lines, scene_.time, pushes_);
  if (!pushed_soundly_ || !std::isfinite(energy_)) return false;
  if (errors_.empty()) return true;
  terms_.volume_gradient().gram(weights_, gram_values_);
  return gram_.factorise(gram_values_);
}

// The kick from the forces at x_, then the drift from x_ with the velocities that it leaves.
void Motion::kick_and_drift(double kick, double drift) {
  const std::span<const energy::VertexLine> lines = terms_.lines();
  energy::VolumeGradient& volume = terms_.volume_gradient();
  volume.set_multipliers(pressures_);
  const bool free = errors_.empty();
  const bool pushed = !pushes_.empty();
  const double kept = std::exp(-scene_.damping * kick);
  next_kinetic_ = work_ = damped_ = 0;
  for (std::size_t v = 0; v < x_.size(); ++v) {
    const Vec3 force = free ? -lines[v].gradient : volume.pull(v) - lines[v].gradient;
    Vec3 velocity = v_[v] + (kick * weights_[v]) * force;
    if (pushed && weights_[v] != 0) {
      velocity += kick * pushes_[v];
      work_ += 0.5 * kick * masses_[v] * dot(pushes_[v], velocity + v_[v]);
    }
    next_v_[v] = kept * velocity;
    next_x_[v] = x_[v] + drift * next_v_[v];
    next_kinetic_ += 0.5 * masses_[v] * squared_length(next_v_[v]);
  }
  damped_ = next_kinetic_ > 0 ? (1 / (kept * kept) - 1) * next_kinetic_ : 0;
}

// The step of the gradient flow; next_v_ is how fast it moves.
void Motion::descend(double dt) {
  const std::span<const energy::VertexLine> lines = terms_.lines();
  energy::VolumeGradient& volume = terms_.volume_gradient();
  volume.set_multipliers(pressures_);
  work_ = damped_ = next_kinetic_ = 0;
  for (std::size_t v = 0; v < x_.size(); ++v) {
    next_v_[v] = weights_[v] * (volume.pull(v) - lines[v].gradient);
    if (!pushes_.empty() && weights_[v] != 0) {
      next_v_[v] += pushes_[v];
      work_ += dt * masses_[v] * dot(pushes_[v], next_v_[v]);
    }
    next_x_[v] = x_[v] + dt * next_v_[v];
  }
}

// Verlet's second half, with the forces at next_x_, where terms_ are.
bool Motion::second_kick(double dt) {
  const std::span<const energy::VertexLine> lines = terms_.lines();
  energy::VolumeGradient& volume = terms_.volume_gradient();
  if (!forces_.empty() && !forces_.evaluate(next_x_, next_v_, lines, scene_.time + dt, pushes_)) return false;
  volume.set_multipliers(next_pressures_);
  const double half = 0.5 * dt;
  const double kept = std::exp(-scene_.damping * half);
  next_kinetic_ = 0;
  for (std::size_t v = 0; v < x_.size(); ++v) {
    const Vec3 before = next_v_[v];
    const Vec3 force = errors_.empty() ? -lines[v].gradient : volume.pull(v) - lines[v].gradient;
    next_v_[v] += (half * weights_[v]) * force;
    if (!pushes_.empty() && weights_[v] != 0) {
      next_v_[v] += half * pushes_[v];
      work_ += 0.5 * half * masses_[v] * dot(pushes_[v], next_v_[v] + before);
    }
    const double undamped = 0.5 * masses_[v] * squared_length(next_v_[v]);
    next_v_[v] = kept * next_v_[v];
    damped_ += (1 - kept * kept) * undamped;
    next_kinetic_ += kept * kept * undamped;
  }
  terms_.constraints().restrict(next_v_);
  if (errors_.empty()) return true;
  volume.gram(weights_, gram_values_);
  if (!gram_.factorise(gram_values_)) return false;
  project_velocities(dt);
  return true;
}

// Takes out of next_v_ what would change volumes other than as their targets do.
void Motion::project_velocities(double dt) {
  energy::VolumeGradient& volume = terms_.volume_gradient();
  std::vector<double>& rates = errors_;
  ones_.assign(x_.size(), 1.0);
  volume.dot(ones_, next_v_, rates);
  for (std::size_t i = 0; i < rates.size(); ++i) {
    const scene::Body& body = scene_.body(terms_.constrained()[i]);
    const double wanted =
        (scene::target_at(body, scene_.time + dt) - scene::target_at(body, scene_.time)) / dt;
    rates[i] = wanted - rates[i];
  }
  gram_.solve(rates, multipliers_);
  volume.set_multipliers(multipliers_);
  next_kinetic_ = 0;
  for (std::size_t v = 0; v < x_.size(); ++v) {
    next_v_[v] += weights_[v] * volume.pull(v);
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
  const double span = method_ == Method::gradient ? dt : method_ == Method::verlet ? 0.5 * dt * dt : dt * dt;
  for (std::size_t i = 0; i < errors_.size(); ++i) next_pressures_[i] += multipliers_[i] / span;
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
  const double before = energy_ + kinetic_ + std::max(0.0, work_);
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
  if (!sound_) return pushed_soundly_ && std::isfinite(energy_) ? Ending::volume_lost : Ending::not_finite;
  if (method_ == Method::gradient) {
    descend(dt);
  } else {
    kick_and_drift(method_ == Method::verlet ? 0.5 * dt : dt, dt);
  }
  terms_.set_time(scene_.time + dt);
  if (!keep_constraints(dt)) return undo(Ending::constraint_lost);
  if (!errors_.empty() && !keep_volumes(dt)) return undo(Ending::volume_lost);
  const double energy = terms_.gradient(next_x_);
  if (method_ == Method::verlet && !second_kick(dt)) return undo(Ending::not_finite);
  if (method_ == Method::gradient) {
    std::fill(next_v_.begin(), next_v_.end(), Vec3{});
    next_kinetic_ = 0;
  }
  const bool finite = std::isfinite(energy + next_kinetic_);
  if (!finite) return undo(Ending::not_finite);
  if (rises_from_nowhere(energy, next_kinetic_)) return undo(Ending::stuck);
  std::swap(x_, next_x_);
  std::swap(v_, next_v_);
  std::swap(pressures_, next_pressures_);
  energy_ = energy;
  kinetic_ = next_kinetic_;
  scene_.work += work_ - damped_;
  scene_.time += dt;
  scene::advance_targets(scene_, scene_.time);
  for (std::size_t i = 0; i < pressures_.size(); ++i)
    scene_.body(terms_.constrained()[i]).pressure = pressures_[i];
  sound_ = linearise();
  return Ending::step_limit;
}

double Motion::fitness() const {
  const double time = method_ == Method::gradient ? std::sqrt(bound_) : bound_;
  return mass_ > 0 ? time / std::sqrt(mass_ / static_cast<double>(terms_.triangle_count())) : 0;
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
