#include "evolution/relax.h"

#include <algorithm>
#include <cmath>

#include "energy/mesh_quality.h"
#include "scene/constraint_sets.h"
#include "solve/reach_volumes.h"
#include "surgery/average.h"
#include "surgery/equiangulate.h"

namespace lamella::evolution {

namespace {

using solve::Ending;
using solve::MotionKind;

// Rounds of free motion, each followed by upkeep: so many iterations, or until the residual is so small.
constexpr int free_rounds = 6;
constexpr long free_iterations = 15;
constexpr double near = 1e-4;
// A mesh is fit while no angle is smaller than this (radians); upkeep goes on while it helps.
constexpr double fit_angle = 20 * M_PI / 180;
constexpr int most_upkeep_passes = 4;
constexpr int most_flip_passes = 3;
constexpr int upkeep_rounds = 5;

// Runs one stretch of the minimiser, and adds what it did to the report.
class Relaxer {
 public:
  Relaxer(scene::Scene& scene, const RelaxOptions& options, scene::Monitor& monitor)
      : scene_(scene), options_(options), monitor_(monitor) {}

  RelaxReport run();

 private:
  bool meet_targets();
  void minimise(MotionKind motion, long iterations, double tolerance);
  bool going() const { return report_.ending == Ending::converged || report_.ending == Ending::step_limit; }
  bool far_from_end() const { return report_.residual > near; }
  bool keep_mesh();

  scene::Scene& scene_;
  const RelaxOptions& options_;
  scene::Monitor& monitor_;
  RelaxReport report_;
};

bool Relaxer::meet_targets() {
  solve::Problem problem(scene_);
  bool ok = false;
  report_.energy = problem.linearise(scene_.film.positions(), ok);
  if (ok && problem.volume_error() < 1e-12 && problem.energy().constraints().empty()) return true;
  if (ok)
    ok = solve::reach_volumes(scene_, problem, scene_.film.edit_positions(), report_.energy) ==
         Ending::converged;
  if (!ok) report_.ending = std::isfinite(report_.energy) ? Ending::volume_lost : Ending::not_finite;
  problem.publish(scene_);
  return ok;
}

void Relaxer::minimise(MotionKind motion, long iterations, double tolerance) {
  solve::Problem problem(scene_);
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

// Flips and one averaging, and more of both while the mesh is unfit and gets better. False if that gained
// nothing.
bool Relaxer::keep_mesh() {
  const double start = energy::smallest_angle(scene_.film);
  double before = start;
  for (int pass = 0; pass < most_upkeep_passes; ++pass) {
    for (int flips = 0; flips < most_flip_passes; ++flips) {
      const std::uint32_t made = surgery::equiangulate(scene_.film);
      report_.flips += made;
      if (made == 0) break;
    }
    surgery::average_vertices(scene_.film);
    scene::constrain_vertices(scene_);
    const double after = energy::smallest_angle(scene_.film);
    if (after > fit_angle || (pass > 0 && after < before)) break;
    before = after;
  }
  return meet_targets() && energy::smallest_angle(scene_.film) > start;
}

RelaxReport Relaxer::run() {
  if (!meet_targets()) return report_;
  if (options_.motion) {
    minimise(*options_.motion, options_.most_iterations, options_.tolerance);
    return report_;
  }
  for (int round = 0; round < free_rounds && going(); ++round) {
    minimise(MotionKind::full, free_iterations, std::max(near, options_.tolerance));
    if (!going() || report_.iterations >= options_.most_iterations) return report_;
    if (options_.upkeep) keep_mesh();
    if (!far_from_end()) break;
  }
  for (int round = 0; round < upkeep_rounds && options_.upkeep && going(); ++round) {
    if (energy::smallest_angle(scene_.film) > fit_angle) break;
    minimise(MotionKind::normal, free_iterations, std::max(near * near, options_.tolerance));
    if (report_.iterations >= options_.most_iterations || !keep_mesh()) break;
  }
  if (going()) minimise(MotionKind::normal, options_.most_iterations, options_.tolerance);
  return report_;
}

}  // namespace

RelaxReport relax(scene::Scene& scene, const RelaxOptions& options, scene::Monitor& monitor) {
  return Relaxer(scene, options, monitor).run();
}

}  // namespace lamella::evolution
