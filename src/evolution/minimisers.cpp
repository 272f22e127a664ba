#include "evolution/minimisers.h"

#include <algorithm>
#include <cmath>

#include "energy/mesh_quality.h"
#include "solve/descent.h"
#include "solve/newton.h"
#include "solve/reach_volumes.h"

namespace lamella::evolution {

namespace {

using solve::Ending;
using solve::MotionKind;

void descend(solve::Problem& problem, solve::DescentRule rule, std::span<film::Vec3> x,
             const RelaxOptions& options, scene::Monitor& monitor, RelaxReport& report) {
  solve::Descent descent(problem, rule);
  double scale = 0;
  report.ending = Ending::step_limit;
  while (report.iterations < options.most_iterations && report.ending == Ending::step_limit) {
    const solve::DescentStep step = descent.step(x, scale, false, HUGE_VAL);
    report.energy = step.energy;
    report.ending = step.ending;
    if (step.ending != Ending::step_limit) break;
    ++report.iterations;
    report.residual = step.predicted_gain / std::abs(step.energy);
    monitor.progress(report.iterations, options.most_iterations, step.energy);
    if (report.residual < options.tolerance) report.ending = Ending::converged;
    if (monitor.stop_requested()) report.ending = Ending::stopped;
  }
  problem.linearise_and_restore(x, report.energy);  // steps leave volumes nearly right
}

void by_lbfgs(solve::Problem& problem, scene::Scene& scene, const RelaxOptions& options,
              scene::Monitor& monitor, RelaxReport& report) {
  solve::LbfgsOptions wanted;
  wanted.most_iterations = options.most_iterations;
  wanted.tolerance = options.tolerance;
  wanted.motion = options.motion.value_or(MotionKind::normal);
  const solve::LbfgsReport part = solve::lbfgs(problem, scene, scene.film.edit_positions(), wanted, monitor);
  report.ending = part.ending;
  report.iterations = part.iterations;
  report.energy = part.energy;
  report.residual = part.residual;
}

void by_newton(solve::Problem& problem, scene::Scene& scene, const RelaxOptions& options,
               scene::Monitor& monitor, RelaxReport& report) {
  solve::Newton method(problem, scene.film, options.motion.value_or(MotionKind::normal));
  solve::NewtonOptions wanted;
  wanted.most_steps = options.most_iterations;
  wanted.tolerance = options.tolerance;
  const solve::NewtonReport part = solve::newton(method, scene.film.edit_positions(), wanted, monitor);
  report.ending = part.ending;
  report.iterations = report.newton_steps = part.steps;
  report.energy = part.energy;
  report.residual = part.residual;
  report.stability = part.stability;
}

}  // namespace

RelaxReport relax_by(Minimiser method, scene::Scene& scene, const RelaxOptions& options,
                     scene::Monitor& monitor) {
  RelaxReport report;
  solve::Problem problem(scene);
  const std::span<film::Vec3> x = scene.film.edit_positions();
  report.ending = solve::reach_volumes(scene, problem, x, report.energy);
  if (report.ending != Ending::converged) return report;
  switch (method) {
    case Minimiser::descent:
      descend(problem, solve::DescentRule::steepest, x, options, monitor, report);
      break;
    case Minimiser::conjugate:
      descend(problem, solve::DescentRule::conjugate, x, options, monitor, report);
      break;
    case Minimiser::lbfgs:
      by_lbfgs(problem, scene, options, monitor, report);
      break;
    case Minimiser::newton:
      by_newton(problem, scene, options, monitor, report);
      break;
  }
  problem.publish(scene);
  report.smallest_angle = energy::smallest_angle(scene.film);
  return report;
}

}  // namespace lamella::evolution
