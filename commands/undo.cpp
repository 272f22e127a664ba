#include "session/session.h"

namespace lamella::session::commands {

namespace {

struct UndoOptions {
  long steps = 1;
};

void run(Session& session, const UndoOptions& options) {
  session.request_undo(options.steps);
}

}  // namespace

extern const Command undo_command =
    make_command<UndoOptions>({.name = "undo",
                               .summary = "take back the last statement that changed the scene",
                               .group = CommandGroup::session,
                               .brings_names = true},
                              {positional("steps", &UndoOptions::steps, "how many").at_least(1)}, run);

}  // namespace lamella::session::commands
