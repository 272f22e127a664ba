#include "evolution/motion.h"

#include <algorithm>
#include <cmath>
#include <utility>

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
  work_ = std::make_unique<SweepWork>(*this);
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
    const bool carried =
        terms_.constraints().moves() && terms_.constraints().holds(static_cast<std::uint32_t>(v));
    if ((stays && !carried) || method_ == Method::gradient) v_[v] = {};
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

// What goes along with a sweep at the end of a step: before it the kick and the move there, after it what
// volumes need of the new lines.
class Motion::SweepWork : public energy::RowWork {
 public:
  explicit SweepWork(Motion& motion)
      : motion_(motion), sums_(motion.terms_.work_parts()), stretches_(sums_.size()) {
    motion_.products_.parts.resize(sums_.size());
  }
  // Products will be of these velocities.
  void start(bool kicks, std::span<const Vec3> velocities) {
    kicks_ = kicks;
    velocities_ = velocities;
    std::fill(sums_.begin(), sums_.end(), KickSums{});
    for (std::vector<Stretch>& part : stretches_) part.clear();
    for (energy::VolumeGradient::RunSums& part : motion_.products_.parts) part.clear();
  }
  void before(std::size_t part, std::size_t first, std::size_t last) override {
    if (kicks_) motion_.kick_rows(motion_.pace_, true, first, last, sums_[part]);
  }
  void after(std::size_t part, std::size_t first, std::size_t last) override {
    const std::size_t end = std::min(last, velocities_.size());  // further rows are images
    if (first >= end) return;
    energy::VolumeGradient::RunSums& sums = motion_.products_.parts[part];
    const double largest = std::exchange(sums.largest, 0);
    motion_.terms_.volume_gradient().add_rows(
        first, end, motion_.answers_, [&](std::size_t v) { return motion_.fields_at(v, velocities_); }, sums);
    stretches_[part].push_back({first, end, sums.largest});
    sums.largest = std::max(sums.largest, largest);
  }
  void collect() {
    motion_.terms_.volume_gradient().collect(
        motion_.answers_, [&](std::size_t v) { return motion_.fields_at(v, velocities_); },
        motion_.products_);
  }
  // The vertices stiffer than this, or some if they are more than `most`.
  void find_stiffer(double least, std::size_t most, std::vector<film::Vertex>& found) const {
    for (const std::vector<Stretch>& part : stretches_) {
      for (const Stretch& stretch : part) {
        if (!(stretch.stiffest > least)) continue;
        for (std::size_t v = stretch.first; v < stretch.last && found.size() <= most; ++v) {
          if (motion_.stiffness_over_mass(v) > least)
            found.push_back(film::Vertex(static_cast<std::uint32_t>(v)));
        }
      }
    }
    std::sort(found.begin(), found.end());
  }
  KickSums sum() const {
    KickSums whole;
    for (const KickSums& part : sums_) whole += part;
    return whole;
  }

 private:
  // Rows that were worked on together, and the largest stiffness over mass among them.
  struct Stretch {
    std::size_t first = 0;
    std::size_t last = 0;
    double stiffest = 0;
  };

  Motion& motion_;
  std::span<const Vec3> velocities_;
  std::vector<KickSums> sums_;
  std::vector<std::vector<Stretch>> stretches_;  // of each part
  bool kicks_ = false;
};

// Whether kick and products can go along with the sweep at the end of a step: nothing else is in between.
bool Motion::goes_with_sweep() const {
  return method_ == Method::euler && terms_.is_plain() && forces_.empty() && held_.empty() &&
         !scene_.mass_of_area && paper_ == nullptr;
}

// The energy at the end of a step, and what goes along with its sweep.
double Motion::sweep_next(bool kicks) {
  multiplied_ = goes_with_sweep();
  if (!multiplied_) return terms_.gradient(next_x_);
  work_->start(kicks, next_v_);
  const double energy = terms_.gradient(next_x_, work_.get());
  work_->collect();
  if (kicks) take_over(work_->sum());
  return energy;
}

// Velocity, acceleration, and stiffness over mass.
energy::VolumeGradient::Fields Motion::fields_at(std::size_t row, std::span<const Vec3> velocities) const {
  const energy::VertexLine& line = terms_.lines()[row];
  const double weight = weights_[row];
  energy::Lane acceleration = -weight * energy::lane_at(&line.gradient.x);
  if (!pushes_.empty() && weight != 0) acceleration += energy::lane_of(pushes_[row]);
  return {energy::load(velocities, row), acceleration, line.stiffness * weight};
}

double Motion::stiffness_over_mass(std::size_t row) const {
  return terms_.lines()[row].stiffness * weights_[row];
}

// After terms_.gradient at x_: outer forces, the bound, and the factors for the volume constraints.
bool Motion::linearise() {
  push();
  return multiply();
}

// Masses where they are the areas, and outer forces.
void Motion::push() {
  const std::span<const energy::VertexLine> lines = terms_.lines();
  if (scene_.mass_of_area) {
    for (std::size_t v = 0; v < masses_.size(); ++v) masses_[v] = lines[v].area;
    weigh();
  }
  forces_.advance(scene_.time);
  pushed_soundly_ = forces_.empty() || forces_.evaluate(x_, v_, lines, scene_.time, pushes_);
}

bool Motion::multiply() {
  work_->start(false, v_);
  terms_.work_after_sweep(*work_);
  work_->collect();
  return conclude();
}

// With the products at x_.
bool Motion::conclude() {
  bound_ = bound_by(closer_rate());
  if (!pushed_soundly_ || !std::isfinite(energy_)) return false;
  return errors_.empty() || gram_.factorise(products_.gram);
}

double Motion::bound_by(double rate) const {
  if (!(rate > 0)) return HUGE_VAL;
  return 2 / (method_ == Method::gradient ? rate : std::sqrt(rate));
}

// A bound on the largest stiffness over mass by which the film swings.
double Motion::closer_rate() {
  const double largest = products_.largest;
  spots_.clear();
  work_->find_stiffer(StiffSpots::watched * largest, StiffSpots::most, spots_);
  if (spots_.empty() || spots_.size() > StiffSpots::most) return largest;
  const energy::SweepInput& input = terms_.input();
  std::span<const Vec3> positions = x_;
  if (!terms_.unfolding().empty()) positions = terms_.unfolding().extend(x_, images_);
  return stiff_spots_.relieve(
      {scene_.film, input.triangles, positions, input.tension, terms_.lines(), weights_}, spots_, largest);
}

Motion::Pace Motion::pace(double dt) const {
  if (method_ == Method::gradient) return {dt, 0, 1, dt, 1};
  const double span = method_ == Method::verlet ? 0.5 * dt : dt;
  return {dt, 1, span, span, std::exp(-scene_.damping * span)};
}

void Motion::prepare_kick() {
  if (!is_free()) terms_.volume_gradient().set_multipliers(pressures_, multipliers_);
}

// The kick from the forces at x_, and where `drifts` the pull of the multipliers and the move after it: all
// in one pass, as memory is what it costs.
void Motion::kick(const Pace& pace, bool drifts) {
  prepare_kick();
  take_over(film::sum_of_blocks(x_.size(), [&](std::size_t first, std::size_t last) {
    KickSums sums;
    kick_rows(pace, drifts, first, last, sums);
    return sums;
  }));
}

void Motion::take_over(const KickSums& sums) {
  next_kinetic_ = 0.5 * energy::sum_of_3(sums.kinetic);
  pushed_ += sums.work;
  damped_ = 0.5 * energy::sum_of_3(sums.kicked) * (1 / (pace_.kept * pace_.kept) - 1);
}

void Motion::kick_rows(const Pace& pace, bool drifts, std::size_t first, std::size_t last, KickSums& sums) {
  using energy::Lane;
  const std::span<const energy::VertexLine> lines = terms_.lines();
  const bool pushed = !pushes_.empty();
  const auto move = [&](std::size_t v, const Lane& pressure, const Lane& impulse) {
    const double weight = weights_[v];
    const Lane before = pace.carried * energy::load(v_, v);
    Lane velocity = before + (pace.push * weight) * (pressure - energy::lane_at(&lines[v].gradient.x));
    if (pushed && weight != 0) {
      const Lane push = energy::lane_of(pushes_[v]);
      velocity += pace.push * push;
      const Lane mean = pace.carried > 0 ? 0.5 * (velocity + before) : velocity;
      sums.work += pace.span * masses_[v] * energy::sum_of_3(push * mean);
    }
    velocity *= pace.kept;
    sums.kicked += masses_[v] * (velocity * velocity);
    if (drifts) {
      velocity += answers_[v] * impulse;
      next_x_[v] = energy::vector_of(energy::load(x_, v) + pace.dt * velocity);
      sums.kinetic += masses_[v] * (velocity * velocity);
    }
    next_v_[v] = energy::vector_of(velocity);
  };
  if (is_free()) {
    for (std::size_t v = first; v < last; ++v) move(v, Lane{}, Lane{});
    return;
  }
  const auto inner = [&](std::size_t from, std::size_t to, double pressure, double impulse) {
    for (std::size_t v = from; v < to; ++v) {
      const Lane vector = terms_.volume_gradient().inner_vector(v);
      move(v, pressure * vector, impulse * vector);
    }
  };
  const auto border = [&](std::size_t v, const Vec3& pressure, const Vec3& impulse) {
    move(v, energy::lane_of(pressure), energy::lane_of(impulse));
  };
  terms_.volume_gradient().for_each_pull(first, last, inner, border);
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

bool Motion::is_loose() const {
  return std::none_of(weights_.begin(), weights_.end(), [](double w) { return w == 0; });
}

// Pressures push a film around without moving it as a whole; where sets are held that do not answer, what is
// missing is given to all alike, which changes no volume. A film that something holds keeps no momentum.
void Motion::give_back_momentum(double dt) {
  if (!holds() || !terms_.constraints().empty()) return;
  if (!is_loose()) return;
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
  const RigidVelocity whole =
      is_loose() ? rigid_velocity(now, x_, masses_, kept_by(scene_)) : RigidVelocity{};
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
    if (!pushes_.empty()) pushed_ += masses_[v] * dot(pushes_[v], moves[v]);
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
      pushed_ += 0.5 * half * masses_[v] * dot(pushes_[v], next_v_[v] + before);
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
  const double before = energy_ + kinetic_ + std::max(0.0, pushed_);
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
bool Motion::propose() {
  const double dt = pace_.dt;
  next_pressures_ = pressures_;
  pushed_ = 0;
  if (is_implicit(method_)) {
    const bool solved = implicit_step(dt);
    watch_.lap(times_.forces);
    return solved;
  }
  if (held_.empty()) {
    if (!is_free()) foresee_volumes(pace_);
    watch_.lap(times_.volumes);
    if (kicks_in_sweep_)
      prepare_kick();
    else
      kick(pace_, true);
    watch_.lap(times_.other);
    return true;
  }
  kick(pace_, false);
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
  pace_ = pace(dt);
  one_pass_ = goes_in_one_pass();
  kicks_in_sweep_ = goes_with_sweep() && (errors_.empty() || one_pass_);
  if (!propose()) return undo(Ending::not_finite);
  terms_.set_time(scene_.time + dt);
  if (!keep_constraints(dt)) return undo(Ending::constraint_lost);
  // A turn changes volumes to second order: what is left to be given back after them is next to nothing.
  give_back_momentum(dt);
  shed_excess(dt);
  if (!errors_.empty() && !keep_volumes(dt)) return undo(Ending::volume_lost);
  give_back_momentum(dt);
  watch_.lap(times_.volumes);
  const double energy = sweep_next(kicks_in_sweep_);
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
  scene_.work += pushed_ - damped_;
  scene_.time += dt;
  scene::advance_targets(scene_, scene_.time);
  for (std::size_t i = 0; i < pressures_.size(); ++i)
    scene_.body(terms_.constrained()[i]).pressure = pressures_[i];
  is_settled_ = false;
  watch_.lap(times_.other);
  if (!multiplied_) push();
  watch_.lap(times_.forces);
  sound_ = multiplied_ ? conclude() : multiply();
  watch_.lap(times_.volumes);
  times_.steps += 1;
  times_.facets += static_cast<double>(terms_.triangle_count());
}

double Motion::fitness() const {
  const double bound = bound_by(products_.largest);
  const double time = method_ == Method::gradient ? std::sqrt(2 * bound) : bound;
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
  store_motion(scene_.film, masses_, velocities_when_settled());
  memory_.store(scene_);
  forces_.store(scene_);
}

}  // namespace lamella::evolution
