#include "session/mesh_commands.h"
#include "session/topology_words.h"
#include "surgery/pop.h"
#include "surgery/pop_strings.h"

namespace lamella::session::commands {

namespace {

void run(Session& session) {
  check_film(session, "to pop");
  scene::Scene& scene = session.scene();
  const surgery::PopReport report =
      scene.strings.on ? surgery::pop_string_vertices(scene, surgery::crowded_string_vertices(scene))
                       : surgery::pop_vertices(scene, surgery::illegal_vertices(scene));
  finish_topology(session, report.events);
  session.counter("vertex_pop_count") = static_cast<double>(report.vertices);
  session.counter("edge_pop_count") = static_cast<double>(report.edges);
  session.tell("Vertices popped: {}\n", report.vertices);
}

}  // namespace

extern const Command pop_vertices_command =
    make_command({.name = "pop_vertices",
                  .aliases = {"o"},
                  .summary = "resolve points that no soap film keeps, by what lowers the area most",
                  .group = CommandGroup::mesh},
                 run);

}  // namespace lamella::session::commands
