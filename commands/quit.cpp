#include "session/session.h"

namespace lamella::session::commands {

namespace {

void run(Session& session) {
  session.request_quit();
}

}  // namespace

extern const Command quit_command = make_command({.name = "quit",
                                                  .aliases = {"q", "bye", "exit"},
                                                  .summary = "end the session",
                                                  .group = CommandGroup::session},
                                                 run);

}  // namespace lamella::session::commands
