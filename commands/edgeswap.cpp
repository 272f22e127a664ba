#include "session/mesh_commands.h"
#include "surgery/flip.h"

namespace lamella::session::commands {

namespace {

struct EdgeswapOptions {
  Selection edges;
};

void run(Session& session, const EdgeswapOptions& options) {
  if (options.edges.generator->kind != language::ElementKind::edge)
    throw text::Error("only edges can be swapped", "edgeswap edge[5]");
  film::Film& film = session.scene().film;
  long swapped = 0;
  for_each_element(*options.edges.generator, session.evaluation(), [&](const language::Element& element) {
    if (const auto diagonal = surgery::flippable(film, film::Edge(element.row))) {
      surgery::flip(film, *diagonal);
      ++swapped;
    }
    return true;
  });
  session.counter("edgeswap_count") = static_cast<double>(swapped);
  if (swapped > 0) session.tell("Edges swapped: {}\n", swapped);
}

}  // namespace

extern const Command edgeswap_command =
    make_command<EdgeswapOptions>({.name = "edgeswap",
                                   .summary = "exchange edges for the other diagonals of their two facets",
                                   .group = CommandGroup::mesh},
                                  {positional("edges", &EdgeswapOptions::edges, "").required()}, run);

}  // namespace lamella::session::commands
