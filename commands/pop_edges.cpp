#include "session/mesh_commands.h"
#include "session/topology_words.h"
#include "surgery/pop.h"

namespace lamella::session::commands {

namespace {

void run(Session& session) {
  check_film(session, "to pop");
  scene::Scene& scene = session.scene();
  std::vector<film::Edge> edges;
  for (std::uint32_t e = 0; e < scene.film.edge_rows(); ++e) {
    if (scene.film.valence(film::Edge(e)) > 3) edges.emplace_back(e);
  }
  const surgery::PopReport report = surgery::pop_edges(scene, edges);
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
