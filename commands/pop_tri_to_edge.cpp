#include <cmath>

#include "session/mesh_commands.h"
#include "session/topology_words.h"
#include "surgery/contract.h"
#include "surgery/pop.h"

namespace lamella::session::commands {

namespace {

struct PopTriToEdgeOptions {
  Selection facets;
};

void run(Session& session, const PopTriToEdgeOptions& options) {
  if (options.facets.generator->kind != language::ElementKind::facet)
    throw text::Error("only a facet becomes an edge", "pop_tri_to_edge facet[5]");
  scene::Scene& scene = session.scene();
  std::vector<surgery::Event> events;
  for_each_element(*options.facets.generator, session.evaluation(), [&](const language::Element& element) {
    const auto corners = scene.film.corners(film::Triangle(element.row));
    for (const film::Vertex v : corners) {
      if (kind_of(surgery::link_of(scene.film, v)) != surgery::LinkKind::tetrahedral) return true;
    }
    const surgery::ContractOptions how{
        .size = surgery::size_at(scene.film, corners[0]), .gain = -HUGE_VAL, .only = surgery::Move::part};
    if (const auto done = surgery::contract(scene, corners, how)) events.push_back(done->event);
    return true;
  });
  session.counter("pop_tri_to_edge_count") = static_cast<double>(events.size());
  finish_topology(session, std::move(events));
}

}  // namespace

extern const Command pop_tri_to_edge_command = make_command<PopTriToEdgeOptions>(
    {.name = "pop_tri_to_edge",
     .summary = "swap neighbours: a facet between three points of four borders becomes an edge",
     .group = CommandGroup::mesh},
    {positional("facets", &PopTriToEdgeOptions::facets, "facets with three borders").required()}, run);

}  // namespace lamella::session::commands
