#include "session/mesh_commands.h"

namespace lamella::session::commands {

namespace {

struct TinyEdgesOptions {
  double length = 0;
};

// Edges that a collapse has lengthened in the meantime are left alone.
void run(Session& session, const TinyEdgesOptions& options) {
  check_film(session, "to weed");
  scene::Scene& scene = session.scene();
  const film::Film& film = scene.film;
  long collapsed = 0;
  for (std::uint32_t i = 0; i < film.edge_rows(); ++i) {
    const film::Edge e(i);
    if (!film.alive(e)) continue;
    if (length(film.vector(e)) >= options.length) continue;
    if (surgery::collapse_edge(scene, e) == surgery::Collapse::done) ++collapsed;
    if (session.monitor().stop_requested()) break;
  }
  finish_surgery(session);
  session.counter("edge_delete_count") = static_cast<double>(collapsed);
  session.tell("Deleted edges: {}\n", collapsed);
}

}  // namespace

extern const Command tiny_edges_command = make_command<TinyEdgesOptions>(
    {.name = "tiny_edges",
     .aliases = {"t", "edgeweed"},
     .summary = "collapse edges shorter than a length",
     .group = CommandGroup::mesh},
    {positional("length", &TinyEdgesOptions::length, "edges shorter than this collapse")
         .required()
         .at_least(0)},
    run);

}  // namespace lamella::session::commands
