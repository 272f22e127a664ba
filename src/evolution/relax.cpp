#include "evolution/relax.h"

#include <algorithm>
#include <cmath>

#include "energy/mesh_quality.h"
#include "energy/plateau.h"
#include "energy/triangle.h"
#include "evolution/new_mesh.h"
#include "evolution/targets_on_the_way.h"
#include "scene/constraint_sets.h"
#include "solve/newton.h"
#include "solve/reach_volumes.h"
#include "solve/saddle.h"
#include "surgery/average.h"
#include "surgery/equiangulate.h"
#include "surgery/widen.h"

namespace lamella::evolution {

namespace {

using film::Vec3;
using solve::Ending;
using solve::MotionKind;

// Rounds of free motion, each followed by upkeep: so many iterations, or until the residual is so small.
constexpr int free_rounds = 6;
constexpr long free_iterations = 15;
constexpr double near = 1e-4;
// A mesh is fit while no angle is smaller than this (radians); upkeep goes on while it helps.
constexpr double fit_angle = 20 * M_PI / 180;
constexpr double wanted_angle = 27 * M_PI / 180;  // some is lost on the way
constexpr int most_upkeep_passes = 20;
constexpr int patience = 4;  // passes without a better smallest angle
constexpr int most_flip_passes = 3;
constexpr int upkeep_rounds = 5;
// Newton's method takes over where the residual is so small: from there it needs two or three steps.
constexpr double newton_near = 1e-6;
constexpr long most_newton_steps = 12;
// Where it does not get there, descent goes on by so many iterations, and it is tried again.
constexpr long iterations_between = 100;
constexpr int most_finishes = 6;
constexpr int most_departures = 5;
// A film collapses where a facet has less than this part of the mean area, and of the smallest at the start,
// and upkeep cannot mend its angles (radians).
constexpr double vanishing = 1e-6;
constexpr double shrunk = 1e-2;
constexpr double hopeless_angle = 2 * M_PI / 180;
// A film with volumes to keep may only have a mesh that vanishes: it gets a new one, so many times.
constexpr int most_new_meshes = 3;
// It must do better than this angle, and may change the energy by this part of it.
constexpr double usable_angle = 5 * M_PI / 180;
constexpr double most_change = 0.15;
constexpr double finer_meshes[] = {1, 1.4, 2, 2.8, 4};
constexpr double finer_is_better = 1.5;  // in the smallest angle, or the next is not worth trying

struct FacetSizes {
  double smallest = HUGE_VAL;
  double mean = 0;
  film::Triangle which;
};

FacetSizes facet_sizes(const film::Film& film) {
  FacetSizes sizes;
  for (std::uint32_t t = 0; t < film.triangle_rows(); ++t) {
    const std::array<Vec3, 3> p = film.points(film::Triangle(t));
    const double area = energy::triangle_area(p[0], p[1], p[2]);
    sizes.mean += area / film.triangle_rows();
    if (area >= sizes.smallest) continue;
    sizes.smallest = area;
    sizes.which = film::Triangle(t);
  }
  return sizes;
}

// Runs one stretch of the minimiser, and adds what it did to the report.
class Relaxer {
 public:
  Relaxer(scene::Scene& scene, const RelaxOptions& options, scene::Monitor& monitor)
      : scene_(scene), options_(options), monitor_(monitor) {}

  RelaxReport run();

 private:
  bool meet_targets();
  bool reach_targets();
  void minimise(MotionKind motion, long iterations, double tolerance);
  bool going() const { return report_.ending == Ending::converged || report_.ending == Ending::step_limit; }
  bool exhausted() const { return report_.iterations >= options_.most_iterations; }
  bool far_from_end() const { return report_.residual > near; }
  bool settled() const { return options_.near_start || std::abs(report_.residual) < newton_near; }
  bool keep_mesh();
  bool start_near();
  void approach();
  void tidy();
  void finish();
  void mend_angles();
  bool find_collapse();
  bool renew_mesh();
  void put_in_order();
  bool newton();
  bool leave();

  scene::Scene& scene_;
  const RelaxOptions& options_;
  scene::Monitor& monitor_;
  RelaxReport report_;
  FacetSizes at_start_;
};

bool Relaxer::meet_targets() {
  solve::Problem problem(scene_);
  bool ok = false;
  report_.energy = problem.linearise(scene_.film.positions(), ok);
  if (ok && problem.volume_error() < 1e-12 && problem.energy().constraints().empty()) return true;
  if (ok) {
    ok = solve::reach_volumes(scene_, problem, scene_.film.edit_positions(), report_.energy) ==
         Ending::converged;
  }
  if (!ok) report_.ending = std::isfinite(report_.energy) ? Ending::volume_lost : Ending::not_finite;
  problem.publish(scene_);
  return ok;
}

// Free parameters stay: they come with Newton's method.
void Relaxer::minimise(MotionKind motion, long iterations, double tolerance) {
  solve::Problem problem(scene_);
  problem.hold_parameters();
  solve::LbfgsOptions options;
  options.motion = motion;
  options.tolerance = tolerance;
  options.most_iterations = std::min(iterations, options_.most_iterations - report_.iterations);
  const solve::LbfgsReport part =
      solve::lbfgs(problem, scene_, scene_.film.edit_positions(), options, monitor_);
  problem.publish(scene_);
  report_.ending = part.ending;
  report_.iterations += part.iterations;
  report_.energy = part.energy;
  report_.residual = part.residual;
}

// Flips and one averaging, and more of both while the mesh is unfit and still gets better. False if that
// gained nothing.
bool Relaxer::keep_mesh() {
  const double start = energy::smallest_angle(scene_.film);
  double best = start;
  int since_best = 0;
  for (int pass = 0; pass < most_upkeep_passes && since_best < patience; ++pass) {
    for (int flips = 0; flips < most_flip_passes; ++flips) {
      const std::uint32_t made = surgery::equiangulate(scene_.film);
      report_.flips += made;
      if (made == 0) break;
    }
    surgery::average_vertices(scene_.film);
    // Far from the end that would keep a neck fit while it vanishes.
    if (settled() && energy::smallest_angle(scene_.film) < wanted_angle)
      surgery::widen_angles(scene_.film, wanted_angle);
    scene::constrain_vertices(scene_);
    const double now = energy::smallest_angle(scene_.film);
    if (now > fit_angle) break;
    since_best = now > best ? 0 : since_best + 1;
    best = std::max(best, now);
  }
  return meet_targets() && energy::smallest_angle(scene_.film) > start;
}

// Volumes that are far from their targets are brought there by strides, and the film into order after each.
bool Relaxer::reach_targets() {
  if (options_.motion || !options_.upkeep) return meet_targets();
  {
    TargetsOnTheWay targets(scene_);
    while (!exhausted() && targets.stride()) {
      if (!meet_targets()) return false;
      minimise(MotionKind::full, free_iterations, near);
      if (!going() && report_.ending != Ending::stuck) return false;
      report_.ending = Ending::converged;
      if (!keep_mesh() && !going()) return false;
    }
  }
  return meet_targets();
}

// From a refined equilibrium: it only has to be smoothed. False if that was too much for Newton's method.
bool Relaxer::start_near() {
  if (!options_.near_start || report_.saddles_left > 0) return false;
  if (options_.upkeep && !keep_mesh() && !going()) return false;
  return newton() && (!options_.upkeep || energy::smallest_angle(scene_.film) > fit_angle);
}

// Free motion from afar, and upkeep in between.
void Relaxer::approach() {
  for (int round = 0; round < free_rounds && going(); ++round) {
    minimise(MotionKind::full, free_iterations, std::max(near, options_.tolerance));
    if (!going() || exhausted()) return;
    if (options_.upkeep) keep_mesh();
    if (energy::smallest_angle(scene_.film) < usable_angle) renew_mesh();
    if (find_collapse() || !far_from_end()) return;
  }
}

// Near the end, while the mesh is unfit and gets better.
void Relaxer::tidy() {
  for (int round = 0; round < upkeep_rounds && options_.upkeep && going() && !exhausted(); ++round) {
    if (energy::smallest_angle(scene_.film) > fit_angle) return;
    minimise(MotionKind::normal, free_iterations, std::max(near * near, options_.tolerance));
    if (exhausted() || !keep_mesh()) return;
  }
}

// Newton's steps, and stability by the last one. True if the residual met the tolerance.
bool Relaxer::newton() {
  solve::Problem problem(scene_);
  solve::Newton method(problem, scene_.film, MotionKind::normal);
  solve::NewtonOptions options;
  options.tolerance = options_.tolerance;
  options.most_steps = std::min(most_newton_steps, options_.most_iterations - report_.iterations);
  const solve::NewtonReport part = solve::newton(method, scene_.film.edit_positions(), options, monitor_);
  problem.publish(scene_);
  report_.iterations += part.steps;
  report_.newton_steps += part.steps;
  report_.energy = part.energy;
  if (part.ending == Ending::stopped) report_.ending = Ending::stopped;
  if (part.ending != Ending::converged) return false;
  report_.ending = Ending::converged;
  report_.residual = part.residual;
  report_.stability = part.stability;
  return true;
}

// Descent along normals until Newton's method can take over, and that. Where it does not get there, descent
// goes farther before the next try.
void Relaxer::finish() {
  double wanted = newton_near;
  int tries = 0;
  while (going() && !exhausted()) {
    minimise(MotionKind::normal, iterations_between, std::max(wanted, options_.tolerance));
    if (report_.converged() && options_.tolerance >= wanted) return;
    if (find_collapse()) return;
    // The way is longer than it looked: free motion gets on faster.
    if (report_.ending == Ending::step_limit && far_from_end()) approach();
    const bool stuck = report_.ending == Ending::stuck;
    // Descent may crawl where Newton's method strides.
    if (!going() && !stuck) return;
    if (far_from_end() && !stuck) continue;
    if (exhausted() || newton() || stuck || report_.ending == Ending::stopped) return;
    wanted = ++tries < most_finishes ? 0.01 * std::min(wanted, std::abs(report_.residual)) : 0;
  }
}

// At the end, where the mesh is unfit still.
void Relaxer::mend_angles() {
  if (!options_.upkeep || !report_.converged() || !report_.stability.known) return;
  if (energy::smallest_angle(scene_.film) > fit_angle) return;
  keep_mesh();
  if (going() && !newton() && going()) finish();
}

// Whether the whole film all but vanished, or a facet that was not like that at the start.
bool Relaxer::find_collapse() {
  const FacetSizes sizes = facet_sizes(scene_.film);
  const bool gone = sizes.mean < vanishing * at_start_.mean;
  const bool vanishes =
      sizes.smallest < vanishing * sizes.mean && sizes.smallest < shrunk * at_start_.smallest;
  if (!gone && !(vanishes && energy::smallest_angle(scene_.film) < hopeless_angle)) return false;
  if (!gone && renew_mesh()) return false;
  report_.ending = Ending::collapsed;
  report_.pinch = scene_.film.position(scene_.film.corners(sizes.which)[0]);
  return true;
}

// Free motion would tear slivers apart, and upkeep takes the shape of a film that is all slivers: then its
// area jumps.
void Relaxer::put_in_order() {
  const film::Film before = scene_.film;
  const double energy = report_.energy;
  keep_mesh();
  if (going() && report_.energy < (1 + most_change) * energy) return;
  const film::Film kept = scene_.film;
  const RelaxReport report = report_;
  scene_.film = before;
  report_.energy = energy;
  report_.ending = Ending::converged;
  if (renew_mesh()) return;
  scene_.film = kept;
  report_ = report;
}

// Facets as large as those of each film, or finer where these are too coarse for its shape. False, and the
// film as it was, if that is not called for, or fails.
bool Relaxer::renew_mesh() {
  const bool wanted =
      options_.upkeep && options_.new_meshes && scene_.has_fixed_volume() && !scene_.film.periodic();
  if (!wanted || report_.new_meshes == most_new_meshes) return false;
  const film::Film before = scene_.film;
  const double energy = report_.energy;
  double last_angle = 0;
  for (const double finer : finer_meshes) {
    make_new_mesh(scene_, finer);
    const bool met =
        energy::smallest_angle(scene_.film) > fit_angle ? meet_targets() : (keep_mesh(), going());
    const bool kept_shape = std::abs(report_.energy - energy) < most_change * energy;
    const double angle = energy::smallest_angle(scene_.film);
    if (met && kept_shape && angle > usable_angle) {
      ++report_.new_meshes;
      at_start_ = facet_sizes(scene_.film);
      return true;
    }
    scene_.film = before;
    report_.energy = energy;
    report_.ending = Ending::converged;
    // Where a piece of the film vanishes, no mesh is fine enough.
    if (angle < hopeless_angle && angle < finer_is_better * last_angle) return false;
    last_angle = angle;
  }
  return false;
}

// Down from a saddle. False if there is no way, or no wish.
bool Relaxer::leave() {
  if (!options_.leave_saddle || !report_.converged() || !report_.stability.known) return false;
  if (report_.stability.negative_modes == 0 || report_.saddles_left == most_departures) return false;
  if (!descend_from_saddle(scene_, monitor_)) return false;
  report_.stability = {};
  ++report_.saddles_left;
  return true;
}

RelaxReport Relaxer::run() {
  if (!reach_targets()) return report_;
  at_start_ = facet_sizes(scene_.film);
  if (options_.motion) {
    minimise(*options_.motion, options_.most_iterations, options_.tolerance);
  } else {
    do {
      if (start_near()) continue;
      if (options_.upkeep && energy::smallest_angle(scene_.film) < fit_angle) put_in_order();
      approach();
      tidy();
      if (going() && !exhausted()) finish();
      mend_angles();
    } while (leave());
  }
  // A stretch on the way may have met its own tolerance when the steps ran out.
  if (report_.converged() && !(std::abs(report_.residual) < options_.tolerance))
    report_.ending = Ending::step_limit;
  report_.smallest_angle = energy::smallest_angle(scene_.film);
  const energy::PlateauAngles angles = energy::plateau_angles(scene_.film);
  report_.crowded = angles.other_borders + angles.other_points;
  return report_;
}

}  // namespace

RelaxReport relax(scene::Scene& scene, const RelaxOptions& options, scene::Monitor& monitor) {
  return Relaxer(scene, options, monitor).run();
}

bool descend_from_saddle(scene::Scene& scene, scene::Monitor& monitor) {
  solve::Problem problem(scene);
  solve::NewtonSystem system(problem, scene.film, MotionKind::normal);
  const std::span<Vec3> x = scene.film.edit_positions();
  bool ok = false;
  system.linearise(x, ok);
  return ok && solve::leave_saddle(system, x, HUGE_VAL, monitor).moved;
}

}  // namespace lamella::evolution
