#include "surgery/equiangulate.h"

#include "session/session.h"

namespace lamella::session::commands {

namespace {

struct EquiangulateOptions {
  long times = 1;
};

void run(Session& session, const EquiangulateOptions& options) {
  if (session.scene().empty())
    throw text::Error("there is no film to equiangulate", "load a datafile first: load \"cube.fe\"");
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
                                      {positional("times", &EquiangulateOptions::times,
                                                  "how many passes; ends early when nothing is left to flip")
                                           .at_least(0)},
                                      run);

}  // namespace lamella::session::commands
