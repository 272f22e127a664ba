#include "session/follow_formulas.h"
#include "session/session.h"

namespace lamella::session::commands {

namespace {

// Values are computed when they are asked for; places are not.
void run(Session& session) {
  follow_formulas(session.scene());
}

}  // namespace

extern const Command recalc_command = make_command(
    {.name = "recalc",
     .aliases = {"showq", "close_show", "free_discards", "whereami", "dump_memlist"},
     .summary = "put vertices onto their constraints and renew periods; values are always up to date",
     .group = CommandGroup::session},
    run);

}  // namespace lamella::session::commands
