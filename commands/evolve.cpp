#include "evolution/hyperbolic.h"
#include "session/session.h"

namespace lamella::session::commands {

namespace {

struct EvolveOptions {
  long steps = 1;
  std::optional<double> dt;
};

[[noreturn]] void fail(const evolution::EvolveReport& report) {
  throw text::Error(
      fmt::format("the film stopped moving after {} steps: {}", report.steps, solve::describe(report.ending)),
      "the mesh may have become too uneven to go on: try u, V or refine, or more damping");
}

void run(Session& session, const EvolveOptions& options) {
  scene::Scene& scene = session.scene();
  if (scene.empty()) throw text::Error("there is no film to move", "load a datafile first: load \"cube.fe\"");
  evolution::StepSize size;
  size.fixed = options.dt;
  const evolution::EvolveReport report = evolution::evolve(scene, options.steps, size, session.monitor());
  const bool failed = report.ending != solve::Ending::step_limit && report.ending != solve::Ending::stopped &&
                      report.ending != solve::Ending::converged;
  if (failed) fail(report);
  if (options.dt && report.substeps > report.steps) {
    session.tell("dt {:g} lies above the stability bound {:.3g}: {} steps were made in {} parts\n",
                 *options.dt, report.bound, report.steps, report.substeps);
  }
  if (report.undone > 0) session.tell("{} steps were taken back and made smaller\n", report.undone);
  session.tell("time {:.6g}: energy {:.12g}, kinetic {:.6g}, {} steps of {:.3g} to {:.3g}\n", scene.time,
               report.energy, report.kinetic, report.substeps, report.smallest_dt, report.largest_dt);
}

}  // namespace

extern const Command evolve_command = make_command<EvolveOptions>(
    {.name = "evolve",
     .summary = "move the film by hyperbolic flow, volumes kept",
     .group = CommandGroup::motion},
    {positional("steps", &EvolveOptions::steps, "how many").at_least(0),
     option("dt", &EvolveOptions::dt,
            "size of a step in units of time; half the stability bound unless given")
         .above(0)
         .or_word("auto")},
    run);

}  // namespace lamella::session::commands
