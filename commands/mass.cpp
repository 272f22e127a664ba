#include "session/session.h"

namespace lamella::session::commands {

namespace {

struct MassOptions {
  std::optional<std::string> of;
};

void run(Session& session, const MassOptions& options) {
  bool& mass_of_area = session.scene().mass_of_area;
  if (options.of) {
    mass_of_area = *options.of == "area";
  } else {
    session.print("mass {}\n", mass_of_area ? "area" : "carried");
  }
}

}  // namespace

extern const Command mass_command = make_command<MassOptions>(
    {.name = "mass",
     .summary = "whether vertices carry their mass, or weigh what their area does",
     .group = CommandGroup::motion},
    {positional("of", &MassOptions::of, "carried, unless set").one_of({"carried", "area"})}, run);

}  // namespace lamella::session::commands
