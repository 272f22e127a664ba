#include "surgery/rebody.h"

#include "session/mesh_commands.h"

namespace lamella::session::commands {

namespace {

// Parts of a body of fixed volume keep what they have of it.
void run(Session& session) {
  check_film(session, "to divide");
  scene::Scene& scene = session.scene();
  const std::uint32_t count = surgery::divide_bodies(scene);
  const std::vector<double> volumes = count > 0 ? session.measures().volumes : std::vector<double>{};
  for (std::size_t b = 0; count > 0 && b < scene.bodies.size(); ++b) {
    scene::Body& body = scene.bodies[b];
    const bool parted =
        std::any_of(scene.bodies.end() - count, scene.bodies.end(), [&](const scene::Body& made) {
          return &made == &body || made.original == (body.original != 0 ? body.original : b + 1);
        });
    if (!parted || !body.fixed_volume()) continue;
    body.target_volume = volumes[b + 1];
    body.ramp.reset();
  }
  session.tell("New bodies: {}\n", count);
}

}  // namespace

extern const Command rebody_command = make_command(
    {.name = "rebody", .summary = "make bodies that have come apart several", .group = CommandGroup::scene},
    run);

}  // namespace lamella::session::commands
