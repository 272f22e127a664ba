#include "session/mesh_commands.h"
#include "surgery/smooth.h"

namespace lamella::session::commands {

namespace {

struct RawvOptions {
  std::optional<Elements> vertices;
  long times = 1;
};

void run(Session& session, const RawvOptions& options) {
  check_film(session, "to average");
  film::Film& film = session.scene().film;
  if (options.vertices && options.vertices->kind != language::ElementKind::vertex)
    throw text::Error("only vertices can be averaged", "raw_vertex_average vertices where valence > 6");
  for (long i = 0; i < options.times && !session.monitor().stop_requested(); ++i) {
    if (!options.vertices) {
      surgery::smooth_vertices(film, surgery::Averaging::free);
    } else {
      for (const language::Element& vertex : options.vertices->list) {
        const film::Vertex v(vertex.row);
        film.move(v, film.position(v) + surgery::averaging_move(film, v, surgery::Averaging::free));
      }
    }
    finish_surgery(session);
    if (!options.vertices) session.tell("Vertex averaging done.\n");
  }
}

}  // namespace

extern const Command rawv_command = make_command<RawvOptions>(
    {.name = "rawv",
     .aliases = {"raw_vertex_average", "rawestv", "rawest_vertex_average"},
     .summary = "move vertices to the middle of their neighbours, volumes left to change",
     .group = CommandGroup::mesh},
    {positional("vertices", &RawvOptions::vertices, "only these, in turn"),
     positional("times", &RawvOptions::times, "how often").at_least(0)},
    run);

}  // namespace lamella::session::commands
