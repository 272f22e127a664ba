#include <cmath>

#include "session/mesh_commands.h"
#include "session/topology_words.h"
#include "surgery/contract.h"
#include "surgery/pop.h"

namespace lamella::session::commands {

namespace {

struct PopEdgeToTriOptions {
  Selection edges;
};

void run(Session& session, const PopEdgeToTriOptions& options) {
  if (options.edges.generator->kind != language::ElementKind::edge)
    throw text::Error("only an edge becomes a triangle", "pop_edge_to_tri edge[5]");
  scene::Scene& scene = session.scene();
  std::vector<surgery::Event> events;
  for_each_element(*options.edges.generator, session.evaluation(), [&](const language::Element& element) {
    const auto ends = scene.film.ends(film::Edge(element.row));
    for (const film::Vertex v : ends) {
      if (kind_of(surgery::link_of(scene.film, v)) != surgery::LinkKind::tetrahedral) return true;
    }
    const surgery::ContractOptions how{
        .size = surgery::size_at(scene.film, ends[0]), .gain = -HUGE_VAL, .only = surgery::Move::join};
    if (const auto done = surgery::contract(scene, ends, how)) events.push_back(done->event);
    return true;
  });
  session.counter("pop_edge_to_tri_count") = static_cast<double>(events.size());
  finish_topology(session, std::move(events));
}

}  // namespace

extern const Command pop_edge_to_tri_command = make_command<PopEdgeToTriOptions>(
    {.name = "pop_edge_to_tri",
     .summary = "swap neighbours: an edge between two points of four borders becomes a facet",
     .group = CommandGroup::mesh},
    {positional("edges", &PopEdgeToTriOptions::edges, "edges of three films").required()}, run);

}  // namespace lamella::session::commands
