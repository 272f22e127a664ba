#include "session/session.h"

namespace lamella::session::commands {

namespace {

void run(Session& session) {
  session.scene().film.compact();
  session.scene().film.restart_numbers();
}

}  // namespace

extern const Command renumber_all_command = make_command(
    {.name = "renumber_all", .summary = "number the elements from 1 on again", .group = CommandGroup::scene},
    run);

}  // namespace lamella::session::commands
