#include "session/session.h"

namespace lamella::session::commands {

namespace {

void run(Session&) {
  throw text::Error("aborted");
}

}  // namespace

extern const Command abort_command = make_command(
    {.name = "abort", .summary = "end what runs, and take it back", .group = CommandGroup::language}, run);

}  // namespace lamella::session::commands
