#include "film/film.h"
#include "session/session.h"
#include "solve/descent.h"

namespace lamella::session::commands {

namespace {

struct DescendOptions {
  long steps = 1;
};

[[noreturn]] void fail(solve::Ending ending) {
  throw text::Error(
      std::string(solve::describe(ending)),
      ending == solve::Ending::volume_lost
          ? "bodies may share all their vertices with fixed ones, or a target may be out of reach: see v"
          : "look for degenerate facets: list facets where area < 1e-12");
}

void run(Session& session, const DescendOptions& options) {
  scene::Scene& scene = session.scene();
  if (scene.empty()) throw text::Error("there is no film to move", "load a datafile first: load \"cube.fe\"");
  solve::Problem problem(scene);
  solve::Descent descent(
      problem, scene.conjugate_gradient ? solve::DescentRule::conjugate : solve::DescentRule::steepest);
  const std::span<film::Vec3> x = scene.film.edit_positions();
  for (long i = options.steps; i > 0; --i) {
    const solve::DescentStep step = descent.step(x, scene.scale.value, scene.scale.fixed, scene.scale.limit);
    const bool moved = step.ending == solve::Ending::step_limit;
    if (!moved && step.ending != solve::Ending::stuck && step.ending != solve::Ending::converged)
      fail(step.ending);
    session.tell("{:3}. {}: {:#17.15g} energy: {:#17.15g}  scale: {:#g}\n", i,
                 scene.strings.on ? "length" : "area", step.area, step.energy, step.scale);
    session.monitor().progress(options.steps - i + 1, options.steps, step.energy);
    if (!moved) {
      session.tell("No step along the gradient lowers the energy any more.\n");
      break;
    }
    if (session.monitor().stop_requested()) break;
  }
  double energy = 0;
  problem.linearise_and_restore(x, energy);  // steps leave volumes nearly right
  problem.publish(scene);
}

}  // namespace

extern const Command g_command = make_command<DescendOptions>(
    {.name = "g",
     .aliases = {"go"},
     .summary = "descent along the forces, each step to the optimum of its line search, volumes kept",
     .group = CommandGroup::motion},
    {positional("steps", &DescendOptions::steps, "how many").at_least(0)}, run);

}  // namespace lamella::session::commands
