#include "evolution/hyperbolic.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "evolution/motion.h"
#include "evolution/retreat.h"
#include "evolution/targets_on_the_way.h"
#include "evolution/upkeep.h"
#include "solve/reach_volumes.h"

namespace lamella::evolution {

namespace {

using solve::Ending;

constexpr int most_halvings = 12;
constexpr int most_parts = 200;  // of a step
// Relative: what steps in one pass may leave, and nobody sets a target for.
constexpr double at_target = 1e-7;
// A fixed step is made in substeps of at most this part of the bound.
constexpr double substep_fraction = 0.8;
// Sheets that come near one another shorten steps to no less than this part.
constexpr double least_part = 0.02;
// The mesh is made fit when its fitness has fallen to this part of the best, and not again within this many
// steps.
constexpr double choked = 0.4;
constexpr double too_stiff = 0.7;  // what keeps the fitness below this part of the best is mended
constexpr double steps_between_upkeeps = 10;
constexpr double implicit_reach = 10;  // an implicit step over an explicit one, unless fixed
// Where steps have become this much shorter than they were, in spite of upkeep, something shrinks to nothing.
constexpr double lost = 1e-3;
constexpr double forgetting = 0.9;  // of the best, where the mesh does not get as fit as it was

// A target that was set at once, or a datafile whose bodies do not have their volumes yet, is met by moving
// the film there at rest: through velocities it would be a blow.
Ending start_at_targets(scene::Scene& scene) {
  // Told by a plain sum, as nearly every motion starts so: factors for the volumes cost more than many steps.
  if (!scene.keep_volumes || missing_volume(scene) < at_target) return Ending::converged;
  solve::Problem problem(scene);
  problem.hold_parameters();
  bool ok = false;
  problem.linearise(scene.film.positions(), ok);
  if (!ok) return Ending::volume_lost;
  if (problem.volume_error() < at_target) return Ending::converged;
  double energy = 0;
  return solve::reach_volumes(scene, problem, scene.film.edit_positions(), energy);
}

void add(StepTimes& sum, const StepTimes& times) {
  sum.forces += times.forces;
  sum.volumes += times.volumes;
  sum.surgery += times.surgery;
  sum.other += times.other;
  sum.steps += times.steps;
  sum.facets += times.facets;
}

// Makes steps one after the other and keeps account of them.
class Walk {
 public:
  Walk(scene::Scene& scene, const StepSize& size, scene::Monitor& monitor, const AfterStep& after_step,
       const OnEvents& on_events, TopologyMemory* memory)
      : scene_(scene),
        motion_(std::make_unique<Motion>(scene, size.method, size.volumes)),
        size_(size),
        monitor_(monitor),
        after_step_(after_step),
        on_events_(on_events),
        memory_(memory),
        topology_(size.keep_energy) {}

  EvolveReport run(long steps);

 private:
  Ending advance(double dt, long steps);
  void keep_mesh();
  void renew_motion();
  double free_step() const;
  void begin_topology();
  bool can_move(const scene::Scene& scene) const;
  bool keep_topology(bool at_end);
  bool go_back(const std::vector<surgery::Tangle>& tangles);
  struct Look {
    bool changed;
    bool sound;
  };
  Look look(bool sound, bool mend);
  double part_of_step(double most) const;

  scene::Scene& scene_;
  std::unique_ptr<Motion> motion_;
  const StepSize& size_;
  scene::Monitor& monitor_;
  const AfterStep& after_step_;
  const OnEvents& on_events_;
  TopologyMemory* memory_;
  TopologyKeeper topology_;
  Retreat retreat_;
  EvolveReport report_;
  double best_fitness_ = 0;  // of the whole run: never forgotten, unlike the scene's
};

// The longest piece of a step that is safe where sheets are near one another, or have met.
double Walk::part_of_step(double most) const {
  if (!size_.topology) return most;
  const double near = topology_.longest_step(scene_, motion_->positions(), motion_->speeds());
  return retreat_.part_of_step() * std::min(most, std::max(near, least_part * most));
}

// Moves by `dt` in pieces below the bound, halving a piece that fails. Films that tangle go back, perhaps to
// before this step began.
Ending Walk::advance(double dt, long steps) {
  const double fraction = size_.fixed ? substep_fraction : 1.0;
  const double end = scene_.time + dt;
  int halvings = 0;
  int parts = 0;
  const double nothing = std::max(1e-9 * dt, 1e-15 * std::abs(end));
  for (double left = dt; left > nothing; left = end - scene_.time) {
    if (monitor_.watched()) motion_->store();
    monitor_.progress(report_.steps, steps, motion_->energy());
    if (monitor_.stop_requested()) return Ending::stopped;
    const double most = part_of_step(std::min(dt, fraction * motion_->largest_step()));
    const double pieces = std::ceil(left / most * (1 - 1e-12));
    const double piece = std::ldexp(left / std::max(1.0, pieces), -halvings);
    const Ending ending = motion_->step(piece);
    if (ending != Ending::step_limit) {
      ++report_.undone;
      if (++halvings > most_halvings) return ending;
      continue;
    }
    halvings = std::max(0, halvings - 1);
    ++report_.substeps;
    keep_mesh();
    // A step whose size is left to the motion ends where it would take too many parts.
    const bool whole = end - scene_.time <= nothing || (!size_.fixed && ++parts >= most_parts);
    const bool last = report_.steps + 1 == steps && whole;
    const double then = scene_.time;
    if (!keep_topology(last)) return Ending::tangled;
    const bool was_taken_back = scene_.time < then;
    best_fitness_ = std::max(best_fitness_, motion_->fitness());
    if (size_.upkeep && motion_->fitness() < lost * best_fitness_) return Ending::collapsed;
    report_.smallest_dt = report_.smallest_dt == 0 ? piece : std::min(report_.smallest_dt, piece);
    report_.largest_dt = std::max(report_.largest_dt, piece);
    if (whole && !was_taken_back) break;
  }
  ++report_.steps;
  if (after_step_) after_step_(*motion_, report_.steps);
  return Ending::step_limit;
}

// After the connectivity or the mesh of the scene has changed.
void Walk::renew_motion() {
  add(report_.times, motion_->times());
  motion_.reset();  // not two of them at a time
  motion_ = std::make_unique<Motion>(scene_, size_.method, size_.volumes);
}

double Walk::free_step() const {
  return size_.fraction * motion_->bound() * (is_implicit(size_.method) ? implicit_reach : 1);
}

// A mesh that chokes the steps is made fit; where that does not help it is not tried again until it is worse.
// What is remembered belongs to the scene, so that a run in two parts is the same run.
void Walk::keep_mesh() {
  scene_.mesh_fitness = std::max(scene_.mesh_fitness, motion_->fitness());
  const bool due = size_.upkeep && motion_->fitness() < choked * scene_.mesh_fitness &&
                   scene_.steps_unkept >= steps_between_upkeeps;
  scene_.steps_unkept += 1;
  if (!due) return;
  scene_.steps_unkept = 0;
  Stopwatch watch;
  motion_->store();
  const scene::Scene before = scene_;
  // What would make films pass through one another is left to the next look, which mends with more care.
  const bool looks = size_.topology && !scene_.film.periodic();
  if (!keep_mesh_in_motion(scene_, motion_->stiffness_at(too_stiff * scene_.mesh_fitness)) ||
      (looks && !topology_.tangles(scene_.film).empty())) {
    scene_ = before;
    watch.lap(report_.times.surgery);
    return;
  }
  renew_motion();
  scene_.mesh_fitness = std::max(motion_->fitness(), forgetting * scene_.mesh_fitness);
  ++report_.upkeeps;
  watch.lap(report_.times.surgery);
}

// A film at rest, and sound as far as its mesh tells, is not searched for sheets that touch before it moves.
void Walk::begin_topology() {
  if (!size_.topology || scene_.film.periodic()) return;
  if (memory_ != nullptr) topology_.take_up(*memory_, scene_.film);
  motion_->store();
  if (topology_.begin(scene_))
    retreat_.remember(scene_, Retreat::Known::unknown);
  else
    keep_topology(true);
}

bool Walk::can_move(const scene::Scene& scene) const {
  scene::Scene copy = scene;
  return Motion(copy, size_.method, size_.volumes).is_sound();
}

// Looks at the film when it has moved far enough, and at the end. False if it tangles whatever is done.
// Events are told while no motion stands on the scene, as whoever hears of them may change it.
bool Walk::keep_topology(bool at_end) {
  if (!size_.topology || scene_.film.periodic()) return true;
  if (!topology_.is_due(motion_->positions(), motion_->last_move(), at_end)) return true;
  Stopwatch watch;
  motion_->store();
  const std::vector<surgery::Tangle> tangles = topology_.tangles(scene_.film);
  bool goes_on = true;
  if (!tangles.empty() && retreat_.ready()) {
    goes_on = go_back(tangles);
  } else {
    if (!tangles.empty()) topology_.forget_way();
    if (look(tangles.empty(), at_end).sound) retreat_.remember(scene_, Retreat::Known::sound);
  }
  motion_->hold_together(retreat_.held());
  watch.lap(report_.times.surgery);
  return goes_on;
}

// What had waited at the moment gone back to does so no longer: it may be what tangled.
bool Walk::go_back(const std::vector<surgery::Tangle>& tangles) {
  const bool goes_on = retreat_.go_back(scene_, tangles);
  topology_.resume(scene_.film);
  ++report_.retreats;
  renew_motion();
  if (!goes_on || !topology_.waits()) return goes_on;
  const Look mended = look(true, true);
  if (mended.changed && mended.sound) retreat_.remember(scene_, Retreat::Known::sound);
  return true;
}

Walk::Look Walk::look(bool sound, bool mend) {
  const scene::Scene before = scene_;
  if (topology_.look(scene_, sound, mend)) {
    std::vector<surgery::Event> events = topology_.take_events();
    // A region that cannot keep its volume must not come about.
    if (motion_->is_sound() && !events.empty() && !can_move(scene_)) {
      scene_ = before;
      topology_.forget_way();
      events.clear();
    }
    if (on_events_ && !events.empty()) {
      const std::uint64_t connectivity = scene_.film.connectivity_revision();
      const std::uint64_t positions = scene_.film.position_revision();
      on_events_(scene_, events);
      // Who hears of events may change the film, and seldom does.
      if (connectivity != scene_.film.connectivity_revision() ||
          positions != scene_.film.position_revision()) {
        topology_.forget_way();
        sound = sound && topology_.tangles(scene_.film).empty();
      }
    }
    renew_motion();
    scene_.mesh_fitness = motion_->fitness();
    return {true, sound};
  }
  return {false, sound};
}

EvolveReport Walk::run(long steps) {
  begin_topology();
  while (report_.steps < steps && report_.ending == Ending::step_limit) {
    if (!std::isfinite(motion_->bound()) && !size_.fixed) {
      report_.ending = Ending::converged;  // nothing in the scene can move
      break;
    }
    report_.ending = advance(size_.fixed ? *size_.fixed : free_step(), steps);
  }
  motion_->leave();
  if (size_.topology && memory_ != nullptr) topology_.leave(*memory_, scene_.film);
  report_.bound = motion_->bound();
  report_.energy = motion_->energy();
  report_.kinetic = motion_->kinetic();
  report_.volume_error = motion_->volume_error();
  add(report_.times, motion_->times());
  report_.topology = topology_.counts();
  return report_;
}

}  // namespace

EvolveReport evolve(scene::Scene& scene, long steps, const StepSize& size, scene::Monitor& monitor,
                    const AfterStep& after_step, const OnEvents& on_events, TopologyMemory* memory) {
  EvolveReport report;
  report.ending = start_at_targets(scene);
  if (report.ending != Ending::converged) return report;
  return Walk(scene, size, monitor, after_step, on_events, memory).run(steps);
}

double stability_bound(const scene::Scene& scene, Method method) {
  scene::Scene copy = scene;
  return Motion(copy, method).bound();
}

}  // namespace lamella::evolution
