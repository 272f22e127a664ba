#include "scene/constraint_sets.h"
#include "session/session.h"
#include "surgery/split_edge.h"

namespace lamella::session::commands {

namespace {

struct LongEdgesOptions {
  double length = 0;
};

// One attempt for each edge as it stands, as in Surface Evolver.
void run(Session& session, const LongEdgesOptions& options) {
  film::Film& film = session.scene().film;
  if (session.scene().empty())
    throw text::Error("there are no edges to halve", "load a datafile first: load \"cube.fe\"");
  const std::uint32_t edges = film.edge_rows();
  const std::uint32_t old_vertices = film.vertex_rows();
  long divided = 0;
  for (std::uint32_t i = 0; i < edges; ++i) {
    const film::Edge e(i);
    if (!film.alive(e)) continue;
    if (length(film.vector(e)) <= options.length) continue;
    surgery::split_edge(film, e);
    ++divided;
  }
  scene::settle_vertices(session.scene(), old_vertices);
  session.counter("edge_refine_count") = static_cast<double>(divided);
  session.tell("New edges: {}\n", divided);
}

}  // namespace

extern const Command long_edges_command = make_command<LongEdgesOptions>(
    {.name = "long_edges",
     .aliases = {"l"},
     .summary = "halve edges longer than a length",
     .group = CommandGroup::mesh},
    {positional("length", &LongEdgesOptions::length, "edges longer than this are halved")
         .required()
         .at_least(0)},
    run);

}  // namespace lamella::session::commands
