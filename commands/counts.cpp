#include "session/session.h"
#include "session/tables.h"

namespace lamella::session::commands {

namespace {

void run(Session& session) {
  session.print("{}", counts_row(session.scene()));
}

}  // namespace

extern const Command counts_command = make_command({.name = "counts",
                                                    .aliases = {"c"},
                                                    .summary = "how many elements there are",
                                                    .group = CommandGroup::measure},
                                                   run);

}  // namespace lamella::session::commands
