#include "evolution/hyperbolic.h"

#include <algorithm>
#include <cmath>

#include "evolution/motion.h"

namespace lamella::evolution {

namespace {

using solve::Ending;

constexpr int most_halvings = 12;
// A fixed step is made in substeps of at most this part of the bound.
constexpr double substep_fraction = 0.8;

// A target that was set at once, or a datafile whose bodies do not have their volumes yet, is met by moving
// the film there at rest: through velocities it would be a blow.
Ending start_at_targets(scene::Scene& scene) {
  if (!scene.keep_volumes || !scene.has_fixed_volume()) return Ending::converged;
  solve::Problem problem(scene);
  bool ok = false;
  problem.linearise(scene.film.positions(), ok);
  if (!ok) return Ending::volume_lost;
  if (problem.volume_error() < 1e-9) return Ending::converged;
  double energy = 0;
  return problem.restore_volumes(scene.film.edit_positions(), energy);
}

// Moves by `dt` in pieces below the bound, halving a piece that fails.
Ending advance(Motion& motion, double dt, double fraction, EvolveReport& report) {
  double left = dt;
  int halvings = 0;
  while (left > 1e-12 * dt) {
    const double pieces = std::ceil(left / (fraction * motion.bound()) * (1 - 1e-12));
    const double piece = std::ldexp(left / std::max(1.0, pieces), -halvings);
    const Ending ending = motion.step(piece);
    if (ending != Ending::step_limit) {
      ++report.undone;
      if (++halvings > most_halvings) return ending;
      continue;
    }
    halvings = std::max(0, halvings - 1);
    left -= piece;
    ++report.substeps;
    report.smallest_dt = report.smallest_dt == 0 ? piece : std::min(report.smallest_dt, piece);
    report.largest_dt = std::max(report.largest_dt, piece);
  }
  return Ending::step_limit;
}

}  // namespace

EvolveReport evolve(scene::Scene& scene, long steps, const StepSize& size, scene::Monitor& monitor) {
  EvolveReport report;
  report.ending = start_at_targets(scene);
  if (report.ending != Ending::converged) return report;
  Motion motion(scene);
  report.ending = Ending::step_limit;
  for (long i = 0; i < steps && report.ending == Ending::step_limit; ++i) {
    if (!std::isfinite(motion.bound()) && !size.fixed) {
      report.ending = Ending::converged;  // nothing in the scene can move
      break;
    }
    const double dt = size.fixed ? *size.fixed : size.fraction * motion.bound();
    report.ending = advance(motion, dt, size.fixed ? substep_fraction : 1.0, report);
    if (report.ending == Ending::step_limit) ++report.steps;
    monitor.progress(i + 1, steps, motion.energy());
    if (monitor.stop_requested()) report.ending = Ending::stopped;
  }
  motion.store();
  report.bound = motion.bound();
  report.energy = motion.energy();
  report.kinetic = motion.kinetic();
  report.volume_error = motion.volume_error();
  return report;
}

double stability_bound(const scene::Scene& scene) {
  scene::Scene copy = scene;
  return Motion(copy).bound();
}

}  // namespace lamella::evolution
