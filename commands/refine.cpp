#include "surgery/refine.h"

#include <cmath>

#include <unistd.h>

#include "film/order.h"
#include "scene/constraint_sets.h"
#include "session/session.h"
#include "session/tables.h"
#include "surgery/sizing.h"
#include "surgery/split_edge.h"
#include "surgery/split_facet.h"

namespace lamella::session::commands {

namespace {

// Rows have 32-bit numbers, and a facet has three sides.
constexpr double most_facets = 1.4e9;
// While it grows, the film before and columns in the making stand beside it.
constexpr double needed_memory = 1.5;

struct RefineOptions {
  std::optional<long> times;
  std::optional<Elements> elements;
};

// Asked for by a slip of the finger, a film larger than the machine would end the program.
void check_size(const film::Film& film, long times) {
  const double factor = std::pow(4.0, static_cast<double>(times));
  const double facets = factor * film.triangle_count();
  const double bytes = factor * static_cast<double>(film.bytes_with_columns());
  const double memory =
      static_cast<double>(::sysconf(_SC_PHYS_PAGES)) * static_cast<double>(::sysconf(_SC_PAGESIZE));
  if (facets < most_facets && needed_memory * bytes < memory) return;
  throw text::Error(
      fmt::format("that would make {:.3g} facets, more than fit into memory", facets),
      "each refine makes four of one; to refine where it matters: refine edges where length > 0.1");
}

void refine_all(Session& session, long times) {
  film::Film& film = session.scene().film;
  check_size(film, times);
  for (long i = 0; i < times; ++i) {
    if (session.monitor().stop_requested()) return;
    const std::uint32_t old_vertices = film.vertex_rows();
    const surgery::RefineCounts counts = surgery::refine(film);
    scene::settle_vertices(session.scene(), old_vertices);
    surgery::halve_sizes(film);
    film::restore_spatial_order_if_large(film);
    session.counter("refine_count") = counts.edges;
    session.counter("edge_refine_count") = counts.edges;
    session.counter("facet_refine_count") = counts.facets;
    session.tell("{}", counts_row(session.scene()));
  }
}

void refine_some(Session& session, const Elements& elements) {
  film::Film& film = session.scene().film;
  const std::uint32_t old_vertices = film.vertex_rows();
  for (const language::Element& element : elements.list) {
    if (elements.kind == language::ElementKind::edge) {
      surgery::split_edge(film, film::Edge(element.row));
    } else {
      surgery::split_facet(film, film::Triangle(element.row));
    }
  }
  scene::settle_vertices(session.scene(), old_vertices);
  surgery::forget_sizes(film, old_vertices);
  const bool edges = elements.kind == language::ElementKind::edge;
  session.counter(edges ? "edge_refine_count" : "facet_refine_count") =
      static_cast<double>(elements.list.size());
  session.tell("{} refined: {}\n", edges ? "Edges" : "Facets", elements.list.size());
}

void run(Session& session, const RefineOptions& options) {
  if (session.scene().empty())
    throw text::Error("there is no film to refine", "load a datafile first: load \"cube.fe\"");
  if (!options.elements) return refine_all(session, options.times.value_or(1));
  if (options.times)
    throw text::Error("chosen elements are refined once", "refine TIMES, or refine ELEMENTS");
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
    {positional("elements", &RefineOptions::elements, "edges to halve, or facets to cut in three"),
     positional("times", &RefineOptions::times, "how often every facet is cut in four; 1 unless given")
         .at_least(0)
         .at_most(20)},
    run);

}  // namespace lamella::session::commands
