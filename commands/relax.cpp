#include "evolution/relax.h"

#include <chrono>

#include "session/session.h"
#include "solve/descent.h"

namespace lamella::session::commands {

namespace {

struct RelaxOptions {
  std::optional<long> steps;
  std::string method = "lbfgs";
  std::optional<std::string> motion;
  bool keep_mesh = false;
  double tolerance = 1e-10;
};

constexpr long most_iterations = 5000;

// Plain descent until a step gains less than the tolerance, as an estimate of the same kind as the other
// method's.
evolution::RelaxReport descend(scene::Scene& scene, long steps, double tolerance, scene::Monitor& monitor) {
  evolution::RelaxReport report;
  solve::Problem problem(scene);
  solve::Descent descent(problem);
  const std::span<film::Vec3> x = scene.film.edit_positions();
  double scale = 0;
  report.ending = solve::Ending::step_limit;
  while (report.iterations < steps && report.ending == solve::Ending::step_limit) {
    const solve::DescentStep step = descent.step(x, scale, false, HUGE_VAL);
    report.energy = step.energy;
    report.ending = step.ending;
    if (step.ending != solve::Ending::step_limit) break;
    ++report.iterations;
    report.residual = step.predicted_gain / std::abs(step.energy);
    monitor.progress(report.iterations, steps, step.energy);
    if (report.residual < tolerance) report.ending = solve::Ending::converged;
    if (monitor.stop_requested()) report.ending = solve::Ending::stopped;
  }
  problem.publish(scene);
  return report;
}

evolution::RelaxReport relax(Session& session, const RelaxOptions& options) {
  const long steps = options.steps.value_or(most_iterations);
  if (options.method == "descent" && options.motion)
    throw text::Error("steepest descent knows no kinds of motion", "motion belongs to method lbfgs");
  if (options.method == "descent")
    return descend(session.scene(), steps, options.tolerance, session.monitor());
  evolution::RelaxOptions wanted;
  wanted.most_iterations = steps;
  wanted.tolerance = options.tolerance;
  wanted.upkeep = !options.keep_mesh;
  if (options.motion)
    wanted.motion = *options.motion == "full" ? solve::MotionKind::full : solve::MotionKind::normal;
  return evolution::relax(session.scene(), wanted, session.monitor());
}

void run(Session& session, const RelaxOptions& options) {
  if (session.scene().empty()) {
    throw text::Error("there is no film to relax", "load a datafile first: load \"cube.fe\"");
  }
  const auto start = std::chrono::steady_clock::now();
  const evolution::RelaxReport report = relax(session, options);
  if (report.ending == solve::Ending::not_finite || report.ending == solve::Ending::volume_lost) {
    throw text::Error(std::string(solve::describe(report.ending)), "look at v and check; g 1 may tell more");
  }
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  session.counter("relax_residual") = report.residual;
  session.counter("relax_converged") = report.ending == solve::Ending::converged ? 1 : 0;
  session.tell("{} after {} iterations: energy {:.12g}, residual {:.2g}, {:.3f} s\n",
               solve::describe(report.ending), report.iterations, report.energy, report.residual,
               seconds.count());
}

}  // namespace

extern const Command relax_command = make_command<RelaxOptions>(
    {.name = "relax",
     .summary = "bring the film to an equilibrium, volumes kept",
     .group = CommandGroup::motion},
    {positional("steps", &RelaxOptions::steps,
                "at most this many iterations; as many as it takes unless given")
         .at_least(0),
     option("method", &RelaxOptions::method, "quasi-Newton in the film's metric, or steepest descent")
         .one_of({"lbfgs", "descent"}),
     option("motion", &RelaxOptions::motion,
            "how vertices move: along normals only, or anywhere; in turn unless given")
         .one_of({"normal", "full"}),
     flag("keep_mesh", &RelaxOptions::keep_mesh, "no flips and no averaging on the way"),
     option("tolerance", &RelaxOptions::tolerance, "estimated relative excess of the energy at which to end")
         .above(0)},
    run);

}  // namespace lamella::session::commands
