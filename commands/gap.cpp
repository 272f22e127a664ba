#include "session/session.h"

namespace lamella::session::commands {

namespace {

struct GapOptions {
  double constant = 1;
};

void run(Session& session, const GapOptions& options) {
  session.scene().gap_constant = options.constant;
}

}  // namespace

extern const Command gap_command = make_command<GapOptions>(
    {.name = "gap",
     .aliases = {"k"},
     .summary = "weight of the energy of gaps between edges and convex constraints",
     .group = CommandGroup::scene},
    {positional("constant", &GapOptions::constant, "1 is nearest to the true area").required().at_least(0)},
    run);

}  // namespace lamella::session::commands
