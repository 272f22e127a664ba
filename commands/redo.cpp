#include "session/session.h"

namespace lamella::session::commands {

namespace {

struct RedoOptions {
  long steps = 1;
};

void run(Session& session, const RedoOptions& options) {
  session.request_undo(-options.steps);
}

}  // namespace

extern const Command redo_command =
    make_command<RedoOptions>({.name = "redo",
                               .summary = "do again what undo took back",
                               .group = CommandGroup::session,
                               .brings_names = true},
                              {positional("steps", &RedoOptions::steps, "how many").at_least(1)}, run);

}  // namespace lamella::session::commands
