#include "session/session.h"

namespace lamella::session::commands {

namespace {

struct AutorecalcOptions {
  std::optional<std::string> state;
};

// Values are always up to date, and nothing is displayed on its own.
void run(Session&, const AutorecalcOptions&) {}

}  // namespace

extern const Command autorecalc_command = make_command<AutorecalcOptions>(
    {.name = "autorecalc",
     .aliases = {"autodisplay", "gv_binary", "metric_conversion"},
     .summary = "accepted, for Surface Evolver's files end with it; without effect",
     .group = CommandGroup::session},
    {positional("state", &AutorecalcOptions::state, "").one_of({"on", "off"})}, run);

}  // namespace lamella::session::commands
