#include "session/mesh_commands.h"
#include "session/topology_words.h"
#include "surgery/pop.h"

namespace lamella::session::commands {

namespace {

void run(Session& session) {
  check_film(session, "to pop");
  scene::Scene& scene = session.scene();
  const surgery::PopReport report = surgery::pop_edges(scene, surgery::crowded_edges(scene.film));
  finish_topology(session, report.events);
  session.counter("vertex_pop_count") = static_cast<double>(report.vertices);
  session.counter("edge_pop_count") = static_cast<double>(report.edges);
  session.tell("Edges popped: {}\n", report.edges);
}

}  // namespace

extern const Command pop_edges_command =
    make_command({.name = "pop_edges",
                  .aliases = {"O"},
                  .summary = "draw apart edges at which more than three films meet",
                  .group = CommandGroup::mesh},
                 run);

}  // namespace lamella::session::commands
