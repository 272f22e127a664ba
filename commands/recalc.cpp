#include "session/session.h"

namespace lamella::session::commands {

namespace {

// Values are computed when they are asked for.
void run(Session&) {}

}  // namespace

extern const Command recalc_command =
    make_command({.name = "recalc",
                  .aliases = {"showq", "close_show", "free_discards", "whereami", "dump_memlist"},
                  .summary = "accepted, for scripts say it; values are always up to date",
                  .group = CommandGroup::session},
                 run);

}  // namespace lamella::session::commands
