#include "scene/constraint_sets.h"
#include "session/mesh_commands.h"
#include "surgery/skinny.h"

namespace lamella::session::commands {

namespace {

struct NotchOptions {
  double angle = 0;
};

void run(Session& session, const NotchOptions& options) {
  check_film(session, "to notch");
  film::Film& film = session.scene().film;
  const std::uint32_t old_vertices = film.vertex_rows();
  const std::uint32_t notched = surgery::notch_edges(film, options.angle);
  scene::settle_vertices(session.scene(), old_vertices);
  session.counter("notch_count") = notched;
  session.tell("Number of edges notched: {}\n", notched);
}

}  // namespace

extern const Command notch_command = make_command<NotchOptions>(
    {.name = "notch",
     .aliases = {"n"},
     .summary = "cut the facets at sharp edges in three",
     .group = CommandGroup::mesh},
    {positional("angle", &NotchOptions::angle, "in radians, between the normals on both sides")
         .required()
         .at_least(0)},
    run);

}  // namespace lamella::session::commands
