#include "evolution/motion.h"

#include <algorithm>
#include <cmath>

#include "energy/volume_products.h"
#include "evolution/masses.h"
#include "evolution/rigid_velocity.h"
#include "film/blocks.h"

namespace lamella::evolution {

namespace {

using solve::Ending;

// A step may raise the total energy by this part of it before it counts as a failure: a symplectic step below
// the bound wobbles by far less, an unstable one grows without limit.
constexpr double most_energy_rise = 0.02;
// Stands for what a step missed of a volume that had to be made again, in parts of what may be missed: nine
// halvings until it is forgotten.
constexpr double distrust = 100;
// Not none: a body whose films are all held must be able to keep its volume.
constexpr double answer_of_held = 1e-4;

}  // namespace

Motion::Motion(scene::Scene& scene, Method method, VolumeMode volumes)
    : scene_(scene),
      method_(method),
      volume_mode_(volumes),
      terms_(scene),
      forces_(scene),
      gram_(terms_.volume_gradient().rows(), terms_.volume_gradient().pattern(),
            solve::GramSolver::Kind::fastest),
      memory_(scene, {terms_.constrained().begin(), terms_.constrained().end()}),
      ones_(terms_.constrained().empty() ? 0 : scene.film.vertex_rows(), 1.0),
      weights_(scene.film.vertex_rows()),
      x_(scene.film.positions().begin(), scene.film.positions().end()),
      v_(x_.size()),
      next_x_(x_.size()),
      next_v_(x_.size()),
      pushes_(forces_.empty() ? 0 : x_.size()),
      errors_(terms_.constrained().size()),
      multipliers_(errors_.size()),
      present_(errors_.size()),
      foreseen_(errors_.size()),
      reached_(errors_.size()),
      next_pressures_(errors_.size()) {
  std::ranges::copy(velocities(scene.film), v_.begin());
  for (const film::Region region : terms_.constrained()) pressures_.push_back(scene.body(region).pressure);
  take_up_swept_places();
  energy_ = terms_.gradient(x_);
  masses_ = carried_masses(scene.film, terms_.lines());
  weigh();
  sound_ = linearise();
  for (std::size_t i = 0; i < present_.size(); ++i)
    present_[i] = terms_.volumes()[terms_.constrained()[i].index];
  if (is_implicit(method)) implicit_ = std::make_unique<ImplicitSolver>(scene, masses_);
  if (volumes == VolumeMode::paper && !errors_.empty()) {
    std::vector<int> rows(scene.bodies.size() + 1, -1);
    for (std::size_t i = 0; i < errors_.size(); ++i)
      rows[terms_.constrained()[i].index] = static_cast<int>(i);
    paper_ = std::make_unique<PaperCorrection>(scene.film, std::move(rows), static_cast<int>(errors_.size()));
  }
}

Motion::~Motion() = default;

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
  answers_ = weights_;
  for (const std::vector<film::Vertex>& set : held_) {
    for (const film::Vertex v : set) answers_[v.index] *= answer_of_held;
  }
}

void Motion::hold_together(std::vector<std::vector<film::Vertex>> sets) {
  if (sets.empty() && held_.empty()) return;
  held_ = std::move(sets);
  weigh();
  sound_ = linearise();
}

// After terms_.gradient at x_: outer forces, the bound, and the factors for the volume constraints.
bool Motion::linearise() {
  const std::span<const energy::VertexLine> lines = terms_.lines();
  if (scene_.mass_of_area) {
    for (std::size_t v = 0; v < masses_.size(); ++v) masses_[v] = lines[v].area;
    weigh();
  }
  forces_.advance(scene_.time);
  pushed_soundly_ = forces_.empty() || forces_.evaluate(x_, v_, lines, scene_.time, pushes_);
  const bool pushed = !pushes_.empty();
  const auto fields = [&](std::size_t v) {
    Vec3 acceleration = -weights_[v] * lines[v].gradient;
    if (pushed && weights_[v] != 0) acceleration += pushes_[v];
    return energy::VolumeGradient::Fields(v_[v], acceleration, lines[v].stiffness * weights_[v]);
  };
  energy::multiply_all(terms_.volume_gradient(), answers_, fields, products_);
  const double stiffest = products_.largest;
  const double rate = method_ == Method::gradient ? stiffest : std::sqrt(stiffest);
  bound_ = stiffest > 0 ? 2 / rate : HUGE_VAL;
  if (!pushed_soundly_ || !std::isfinite(energy_)) return false;
  return errors_.empty() || gram_.factorise(products_.gram);
}

Motion::Pace Motion::pace(double dt) const {
  if (method_ == Method::gradient) return {dt, 0, 1, dt, 1};
  const double span = method_ == Method::verlet ? 0.5 * dt : dt;
  return {dt, 1, span, span, std::exp(-scene_.damping * span)};
}

// The kick from the forces at x_, and where `drifts` the pull of the multipliers and the move after it: all
// in one pass, as memory is what it costs.
void Motion::kick(const Pace& pace, bool drifts) {
  energy::VolumeGradient& volume = terms_.volume_gradient();
  if (!is_free()) volume.set_multipliers(pressures_, multipliers_);
  const KickSums sums = film::sum_of_blocks(
      x_.size(), [&](std::size_t first, std::size_t last) { return kick_rows(pace, drifts, first, last); });
  next_kinetic_ = sums.kinetic;
  work_ += sums.work;
  damped_ = sums.kicked * (1 / (pace.kept * pace.kept) - 1);
}

Motion::KickSums Motion::kick_rows(const Pace& pace, bool drifts, std::size_t first, std::size_t last) {
  const std::span<const energy::VertexLine> lines = terms_.lines();
  const energy::VolumeGradient& volume = terms_.volume_gradient();
  const bool free = is_free();
  const bool pushed = !pushes_.empty();
  KickSums sums;
  for (std::size_t v = first; v < last; ++v) {
    const double weight = weights_[v];
    const auto [pressure, impulse] = free ? std::pair<Vec3, Vec3>{} : volume.pulls(v);
    Vec3 velocity = pace.carried * v_[v] + (pace.push * weight) * (pressure - lines[v].gradient);
    if (pushed && weight != 0) {
      velocity += pace.push * pushes_[v];
      const Vec3 mean = pace.carried > 0 ? 0.5 * (velocity + v_[v]) : velocity;
      sums.work += pace.span * masses_[v] * dot(pushes_[v], mean);
    }
    velocity = pace.kept * velocity;
    sums.kicked += 0.5 * masses_[v] * squared_length(velocity);
    if (drifts) {
      velocity += weight * impulse;
      next_x_[v] = x_[v] + pace.dt * velocity;
      sums.kinetic += 0.5 * masses_[v] * squared_length(velocity);
    }
    next_v_[v] = velocity;
  }
  return sums;
}

// Velocities with the pull of the multipliers, and the move with them.
void Motion::drift(double dt) {
  const energy::VolumeGradient& volume = terms_.volume_gradient();
  const bool free = is_free();
  next_kinetic_ = 0;
  for (std::size_t v = 0; v < x_.size(); ++v) {
    if (!free) next_v_[v] += answers_[v] * volume.pull(v);
    next_x_[v] = x_[v] + dt * next_v_[v];
    next_kinetic_ += 0.5 * masses_[v] * squared_length(next_v_[v]);
  }
}

// Sets that are held together get their mean velocity, or none where one of their vertices stays.
void Motion::stiffen() {
  for (const std::vector<film::Vertex>& set : held_) {
    Vec3 momentum;
    double mass = 0;
    bool stays = false;
    for (const film::Vertex v : set) {
      momentum += masses_[v.index] * next_v_[v.index];
      mass += masses_[v.index];
      stays = stays || weights_[v.index] == 0;
    }
    const Vec3 mean = stays || mass <= 0 ? Vec3{} : momentum / mass;
    for (const film::Vertex v : set) {
      const Vec3& velocity = next_v_[v.index];
      damped_ += 0.5 * masses_[v.index] * (squared_length(velocity) - squared_length(mean));
      next_v_[v.index] = mean;
    }
  }
}

// Pressures push a film around without moving it as a whole; where sets are held that do not answer, what is
// missing is given to all alike, which changes no volume. A film that something holds keeps no momentum.
void Motion::give_back_momentum(double dt) {
  if (!holds() || !terms_.constraints().empty()) return;
  if (std::any_of(weights_.begin(), weights_.end(), [](double w) { return w == 0; })) return;
  const Balance now = evolution::balance(x_, next_v_, masses_);
  Balance missing;
  missing.mass = now.mass;
  missing.momentum = kicked_.momentum - now.momentum;
  missing.angular_momentum = kicked_.angular_momentum - now.angular_momentum;
  const RigidVelocity shift = rigid_velocity(missing, x_, masses_, kept_by(scene_));
  next_kinetic_ = 0;
  for (std::size_t v = 0; v < next_v_.size(); ++v) {
    next_v_[v] += shift.at(x_[v]);
    next_x_[v] += dt * shift.at(x_[v]);
    next_kinetic_ += 0.5 * masses_[v] * squared_length(next_v_[v]);
  }
}

// Where sets are held that do not answer to pressures, volumes imposed on velocities that do not keep them
// may speed up what is around. No energy comes from that: it is taken from what is not the motion of the
// whole, which leaves the momenta and, of targets that rest, the volumes.
void Motion::shed_excess(double dt) {
  if (!holds()) return;
  const Balance now = evolution::balance(x_, next_v_, masses_);
  const double excess = now.kinetic - kicked_.kinetic;
  if (excess <= 0) return;
  const bool stays = std::any_of(weights_.begin(), weights_.end(), [](double w) { return w == 0; });
  const RigidVelocity whole = stays ? RigidVelocity{} : rigid_velocity(now, x_, masses_, kept_by(scene_));
  double inner = 0;
  for (std::size_t v = 0; v < x_.size(); ++v)
    inner += 0.5 * masses_[v] * squared_length(next_v_[v] - whole.at(x_[v]));
  const double factor = inner > excess ? std::sqrt(1 - excess / inner) : 0;
  next_kinetic_ = 0;
  for (std::size_t v = 0; v < x_.size(); ++v) {
    const Vec3 rigid = whole.at(x_[v]);
    next_v_[v] = rigid + factor * (next_v_[v] - rigid);
    next_x_[v] = x_[v] + dt * next_v_[v];
    next_kinetic_ += 0.5 * masses_[v] * squared_length(next_v_[v]);
  }
}

// next_x_, next_v_ and next_pressures_ by one of the implicit methods. Damping acts half before, half after.
bool Motion::implicit_step(double dt) {
  const bool centred = method_ == Method::midpoint;
  const double kept = std::exp(-scene_.damping * (centred ? 0.5 * dt : dt));
  const double before = centred ? kept : 1;
  for (std::size_t v = 0; v < x_.size(); ++v) {
    next_v_[v] = before * v_[v];
    next_x_[v] = x_[v] + 0.5 * dt * next_v_[v];
  }
  if (!forces_.empty() && centred &&
      !forces_.evaluate(next_x_, next_v_, terms_.lines(), scene_.time + 0.5 * dt, pushes_))
    return false;
  for (std::size_t i = 0; i < errors_.size(); ++i) foreseen_[i] = target(i, scene_.time + dt);
  const ImplicitStart start{x_, next_v_, pushes_, foreseen_, scene_.time, dt};
  const std::span<Vec3> moves = next_x_;
  const bool solved = centred ? implicit_->midpoint(start, moves, next_pressures_)
                              : implicit_->euler(start, moves, next_pressures_);
  if (!solved) return false;
  next_kinetic_ = 0;
  for (std::size_t v = 0; v < x_.size(); ++v) {
    if (!pushes_.empty()) work_ += masses_[v] * dot(pushes_[v], moves[v]);
    next_v_[v] = centred ? kept * ((2 / dt) * moves[v] - next_v_[v]) : (kept / dt) * moves[v];
    next_x_[v] = x_[v] + moves[v];
    next_kinetic_ += 0.5 * masses_[v] * squared_length(next_v_[v]);
  }
  damped_ = (1 / (kept * kept) - 1) * next_kinetic_ + (1 - before * before) * kinetic_;
  return true;
}

// The end of a step of Verlet or midpoint, with the forces at next_x_, where terms_ are.
bool Motion::second_kick(double dt) {
  if (method_ == Method::midpoint) {
    terms_.constraints().restrict(next_v_);
    return errors_.empty() || settle_velocities(dt);
  }
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
  return errors_.empty() || settle_velocities(dt);
}

// Velocities that keep the volumes at next_x_.
bool Motion::settle_velocities(double dt) {
  terms_.volume_gradient().gram(answers_, products_.gram);
  if (!gram_.factorise(products_.gram)) return false;
  project_velocities(dt);
  return true;
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

// Fills next_x_, next_v_, next_pressures_ with where the method goes, volumes kept to first order.
bool Motion::propose(double dt) {
  next_pressures_ = pressures_;
  work_ = 0;
  if (is_implicit(method_)) {
    const bool solved = implicit_step(dt);
    watch_.lap(times_.forces);
    return solved;
  }
  const Pace pace = this->pace(dt);
  if (held_.empty()) {
    if (!is_free()) foresee_volumes(pace);
    watch_.lap(times_.volumes);
    kick(pace, true);
    watch_.lap(times_.other);
    return true;
  }
  kick(pace, false);
  kicked_ = evolution::balance(x_, next_v_, masses_);
  stiffen();
  watch_.lap(times_.other);
  if (!is_free()) {
    terms_.volume_gradient().dot(ones_, next_v_, errors_);
    impose_volumes(dt);
    terms_.volume_gradient().set_multipliers(multipliers_);
  }
  watch_.lap(times_.volumes);
  drift(dt);
  watch_.lap(times_.other);
  return true;
}

Ending Motion::step(double dt) {
  if (!sound_) return pushed_soundly_ && std::isfinite(energy_) ? Ending::volume_lost : Ending::not_finite;
  watch_.start();
  if (!propose(dt)) return undo(Ending::not_finite);
  terms_.set_time(scene_.time + dt);
  if (!keep_constraints(dt)) return undo(Ending::constraint_lost);
  // A turn changes volumes to second order: what is left to be given back after them is next to nothing.
  give_back_momentum(dt);
  shed_excess(dt);
  if (!errors_.empty() && !keep_volumes(dt)) return undo(Ending::volume_lost);
  give_back_momentum(dt);
  watch_.lap(times_.volumes);
  const double energy = terms_.gradient(next_x_);
  watch_.lap(times_.forces);
  if ((one_pass_ || relies_on_sweep_) && missed_too_far(dt)) {
    undo(Ending::volume_lost);
    if (one_pass_) memory_.distrust(distrust * most_missed());
    distrusts_rate_ = !one_pass_;
    return step(dt);
  }
  if (holds() && missed_too_far(dt)) return undo(Ending::volume_lost);  // turned too fast
  distrusts_rate_ = false;
  const bool centred = method_ == Method::verlet || method_ == Method::midpoint;
  if (centred && !second_kick(dt)) return undo(Ending::not_finite);
  if (method_ == Method::gradient) {
    std::fill(next_v_.begin(), next_v_.end(), Vec3{});
    next_kinetic_ = 0;
  }
  if (!std::isfinite(energy + next_kinetic_)) return undo(Ending::not_finite);
  if (rises_from_nowhere(energy, next_kinetic_)) return undo(Ending::stuck);
  accept(dt, energy);
  return Ending::step_limit;
}

void Motion::accept(double dt, double energy) {
  if (!errors_.empty()) remember_volumes(dt);
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
  is_settled_ = false;
  watch_.lap(times_.other);
  sound_ = linearise();
  watch_.lap(times_.volumes);
  times_.steps += 1;
  times_.facets += static_cast<double>(terms_.triangle_count());
}

double Motion::fitness() const {
  const double time = method_ == Method::gradient ? std::sqrt(2 * bound_) : bound_;
  return mass_ > 0 ? time / std::sqrt(mass_ / static_cast<double>(terms_.triangle_count())) : 0;
}

double Motion::stiffness_at(double fitness) const {
  const double facets = static_cast<double>(terms_.triangle_count());
  return 4 * facets / (mass_ * fitness * fitness);  // 2/root(rate) over root(mass/facets) is the fitness
}

double Motion::last_move() const {
  double most = 0;
  for (std::size_t v = 0; v < x_.size(); ++v) most = std::max(most, squared_length(x_[v] - next_x_[v]));
  return std::sqrt(most);
}

void Motion::store() {
  std::ranges::copy(settled(), scene_.film.edit_positions().begin());
  store_motion(scene_.film, masses_, v_);
  memory_.store(scene_);
  forces_.store(scene_);
}

}  // namespace lamella::evolution
