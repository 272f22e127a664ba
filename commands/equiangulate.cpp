#include "surgery/equiangulate.h"

#include "session/session.h"

namespace lamella::session::commands {

namespace {

struct EquiangulateOptions {
  std::optional<Selection> edges;
  long times = 1;
};

void equiangulate_some(Session& session, const language::Generator& edges) {
  if (edges.kind != language::ElementKind::edge)
    throw text::Error("only edges can be switched", "equiangulate edge where length > 0.1");
  film::Film& film = session.scene().film;
  long flips = 0;
  for_each_element(edges, session.evaluation(), [&](const language::Element& element) {
    flips += surgery::equiangulate(film, film::Edge(element.row)) ? 1 : 0;
    return true;
  });
  session.counter("equi_count") = static_cast<double>(flips);
  if (flips > 0) session.tell("Edges equiangulated: {}\n", flips);
}

void run(Session& session, const EquiangulateOptions& options) {
  if (session.scene().empty())
    throw text::Error("there is no film to equiangulate", "load a datafile first: load \"cube.fe\"");
  if (options.edges) return equiangulate_some(session, *options.edges->generator);
  for (long i = 0; i < options.times && !session.monitor().stop_requested(); ++i) {
    const std::uint32_t flips = surgery::equiangulate(session.scene().film);
    session.counter("equi_count") = flips;
    session.tell("Edges switched in equiangulation: {}\n", flips);
    if (flips == 0) return;
  }
}

}  // namespace

extern const Command equiangulate_command =
    make_command<EquiangulateOptions>({.name = "equiangulate",
                                       .aliases = {"u"},
                                       .summary = "flip edges to make facets as equiangular as they can be",
                                       .group = CommandGroup::mesh},
                                      {positional("edges", &EquiangulateOptions::edges, "only these, once"),
                                       positional("times", &EquiangulateOptions::times,
                                                  "how many passes; ends early when nothing is left to flip")
                                           .at_least(0)},
                                      run);

}  // namespace lamella::session::commands
