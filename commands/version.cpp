#include "session/program.h"
#include "session/session.h"

namespace lamella::session::commands {

namespace {

void run(Session& session) {
  session.print("lamella {}\n", version());
}

}  // namespace

extern const Command version_command = make_command(
    {.name = "version", .summary = "which version of the program runs", .group = CommandGroup::session}, run);

}  // namespace lamella::session::commands
