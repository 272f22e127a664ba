#include "surgery/refine.h"

#include "film/order.h"
#include "session/session.h"
#include "session/tables.h"
#include "surgery/split_edge.h"
#include "surgery/split_facet.h"

namespace lamella::session::commands {

namespace {

struct RefineOptions {
  long times = 1;
  std::optional<Elements> elements;
};

void refine_all(Session& session, long times) {
  film::Film& film = session.scene().film;
  for (long i = 0; i < times; ++i) {
    if (session.monitor().stop_requested()) return;
    const surgery::RefineCounts counts = surgery::refine(film);
    film::restore_spatial_order_if_large(film);
    session.counter("refine_count") = counts.facets;
    session.counter("edge_refine_count") = counts.edges;
    session.tell("{}", counts_row(session.scene()));
  }
}

void refine_some(Session& session, const Elements& elements) {
  film::Film& film = session.scene().film;
  for (const language::Element& element : elements.list) {
    if (elements.kind == language::ElementKind::edge) {
      surgery::split_edge(film, film::Edge(element.row));
    } else {
      surgery::split_facet(film, film::Triangle(element.row));
    }
  }
  const bool edges = elements.kind == language::ElementKind::edge;
  session.counter(edges ? "edge_refine_count" : "facet_refine_count") =
      static_cast<double>(elements.list.size());
  session.tell("{} refined: {}\n", edges ? "Edges" : "Facets", elements.list.size());
}

void run(Session& session, const RefineOptions& options) {
  if (!options.elements) return refine_all(session, options.times);
  const language::ElementKind kind = options.elements->kind;
  if (kind != language::ElementKind::edge && kind != language::ElementKind::facet) {
    throw text::Error("only edges and facets can be refined", "refine edges where length > 0.1");
  }
  refine_some(session, *options.elements);
}

}  // namespace

extern const Command refine_command = make_command<RefineOptions>(
    {.name = "refine",
     .aliases = {"r"},
     .summary = "halve every edge and cut every facet in four, or divide chosen ones",
     .group = CommandGroup::mesh},
    {positional("times", &RefineOptions::times, "how often").at_least(0).at_most(20),
     positional("elements", &RefineOptions::elements, "edges to halve, or facets to cut in three")},
    run);

}  // namespace lamella::session::commands
