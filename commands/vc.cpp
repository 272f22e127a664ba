#include "session/session.h"
#include "session/tables.h"
#include "solve/problem.h"
#include "solve/reach_volumes.h"

namespace lamella::session::commands {

namespace {

struct VolumeControlOptions {
  std::optional<std::string> mode;
  std::optional<long> body;
  std::optional<double> volume;
  std::optional<double> over;
};

// Moves the film along its volume gradients to its targets.
void restore(Session& session) {
  scene::Scene& scene = session.scene();
  solve::Problem problem(scene);
  problem.hold_parameters();
  double energy = 0;
  const solve::Ending ending = solve::reach_volumes(scene, problem, scene.film.edit_positions(), energy);
  if (ending != solve::Ending::converged) {
    throw text::Error(std::string(solve::describe(ending)),
                      "fixed vertices may not let it; a smaller change, or one over a time, may get there");
  }
}

void set_target(Session& session, const VolumeControlOptions& options) {
  scene::Scene& scene = session.scene();
  const auto row = static_cast<std::size_t>(*options.body - 1);
  if (row >= scene.bodies.size() || scene.bodies[row].absent) {
    throw text::Error(fmt::format("there is no body {}", *options.body),
                      scene.bodies.empty() ? "this scene has no bodies"
                                           : fmt::format("bodies are numbered 1 to {}", scene.bodies.size()));
  }
  if (!options.volume) throw text::Error("a volume is missing", "vc BODY VOLUME, as in: vc 1 2.5");
  scene::Body& body = scene.bodies[row];
  body.fixed_pressure.reset();
  body.ramp.reset();
  if (options.over) {
    const double from = body.target_volume.value_or(session.measures().volumes[row + 1]);
    body.ramp = scene::VolumeRamp{from, *options.volume, scene.time, scene.time + *options.over};
    body.target_volume = from;
    session.tell("body {}: target volume from {:g} to {:g} until time {:g}\n", row + 1, from, *options.volume,
                 scene.time + *options.over);
    return;
  }
  body.target_volume = *options.volume;
  if (scene.keep_volumes) restore(session);
}

void run(Session& session, const VolumeControlOptions& options) {
  scene::Scene& scene = session.scene();
  if (options.mode && (options.body || options.over))
    throw text::Error(fmt::format("vc {} takes nothing else", *options.mode),
                      "a target is set by: vc BODY VOLUME");
  if (options.over && !options.body)
    throw text::Error("over belongs to a new target", "as in: vc 1 2.5 over 0.5");
  if (options.mode) {
    scene.keep_volumes = *options.mode == "on";
    session.tell("Volumes are {}.\n", scene.keep_volumes ? "kept" : "free");
    return;
  }
  if (options.body) {
    set_target(session, options);
  } else if (!scene.has_fixed_volume()) {
    throw text::Error("no body has a target volume", "vc BODY VOLUME sets one");
  } else if (!scene.keep_volumes) {
    throw text::Error("volumes are free", "vc on keeps them again");
  } else {
    restore(session);
  }
  session.tell("{}", volume_table(scene, session.measures()));
}

}  // namespace

extern const Command vc_command = make_command<VolumeControlOptions>(
    {.name = "vc",
     .summary = "volume correction: restore, set or free the volumes of bodies",
     .group = CommandGroup::motion},
    {positional("mode", &VolumeControlOptions::mode, "keep volumes or let them go").one_of({"on", "off"}),
     positional("body", &VolumeControlOptions::body, "number of the body whose target is set").at_least(1),
     positional("volume", &VolumeControlOptions::volume, "its new target volume").above(0),
     option("over", &VolumeControlOptions::over, "reach the target after this much time of evolve").above(0)},
    run);

}  // namespace lamella::session::commands
