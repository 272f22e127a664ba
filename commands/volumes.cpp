#include "session/session.h"
#include "session/tables.h"

namespace lamella::session::commands {

namespace {

void run(Session& session) {
  if (scene::body_count(session.scene()) == 0) {
    session.print("No bodies.\n");
  } else {
    session.print("{}", volume_table(session.scene(), session.measures()));
  }
}

}  // namespace

extern const Command volumes_command = make_command({.name = "volumes",
                                                     .aliases = {"v", "show_vol"},
                                                     .summary = "volumes and pressures of the bodies",
                                                     .group = CommandGroup::measure},
                                                    run);

}  // namespace lamella::session::commands
