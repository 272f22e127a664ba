#include "session/mesh_commands.h"

namespace lamella::session::commands {

namespace {

void run(Session& session) {
  check_film(session, "with volumes");
  scene::Scene& scene = session.scene();
  const std::vector<double> volumes = session.measures().volumes;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    scene::Body& body = scene.bodies[b];
    if (!body.fixed_volume()) continue;
    body.target_volume = volumes[b + 1];
    body.ramp.reset();
  }
  session.tell("Target volumes adjusted.\n");
}

}  // namespace

extern const Command targets_command = make_command({.name = "targets",
                                                     .aliases = {"N"},
                                                     .summary = "set target volumes to the present ones",
                                                     .group = CommandGroup::scene},
                                                    run);

}  // namespace lamella::session::commands
