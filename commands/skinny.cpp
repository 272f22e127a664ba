#include "surgery/skinny.h"

#include "scene/constraint_sets.h"
#include "session/mesh_commands.h"

namespace lamella::session::commands {

namespace {

struct SkinnyOptions {
  double angle = 0;
};

void run(Session& session, const SkinnyOptions& options) {
  check_film(session, "to divide");
  film::Film& film = session.scene().film;
  const std::uint32_t old_vertices = film.vertex_rows();
  const std::uint32_t divided = surgery::divide_skinny_facets(film, options.angle);
  scene::settle_vertices(session.scene(), old_vertices);
  session.counter("edge_refine_count") = divided;
  session.tell("New edges: {}\n", divided);
}

}  // namespace

extern const Command skinny_command = make_command<SkinnyOptions>(
    {.name = "skinny",
     .aliases = {"K"},
     .summary = "halve the longest edge of facets with a small angle",
     .group = CommandGroup::mesh},
    {positional("angle", &SkinnyOptions::angle, "in radians: facets with a smaller angle are divided")
         .required()
         .at_least(0)},
    run);

}  // namespace lamella::session::commands
