#include "session/mesh_commands.h"
#include "session/topology_words.h"
#include "surgery/swap_strings.h"

namespace lamella::session::commands {

namespace {

struct T1EdgeswapOptions {
  Selection edges;
};

void run(Session& session, const T1EdgeswapOptions& options) {
  scene::Scene& scene = session.scene();
  if (!scene.strings.on)
    throw text::Error("t1_edgeswap is for films of one dimension",
                      "pop_tri_to_edge and pop_edge_to_tri swap neighbours in films with facets");
  if (options.edges.generator->kind != language::ElementKind::edge)
    throw text::Error("only edges can be swapped", "t1_edgeswap edge[5]");
  std::vector<surgery::Event> events;
  for_each_element(*options.edges.generator, session.evaluation(), [&](const language::Element& element) {
    if (const auto done = surgery::swap_at_string(scene, film::Edge(element.row))) events.push_back(*done);
    return true;
  });
  session.counter("t1_edgeswap_count") = static_cast<double>(events.size());
  if (!events.empty()) session.tell("T1 swaps: {}\n", events.size());
  finish_topology(session, std::move(events));
}

}  // namespace

extern const Command t1_edgeswap_command =
    make_command<T1EdgeswapOptions>({.name = "t1_edgeswap",
                                     .summary = "swap neighbours in a film of one dimension",
                                     .group = CommandGroup::mesh},
                                    {positional("edges", &T1EdgeswapOptions::edges, "").required()}, run);

}  // namespace lamella::session::commands
