#include "session/session.h"

namespace lamella::session::commands {

namespace {

struct GravitationOptions {
  std::optional<double> constant;
};

void run(Session& session, const GravitationOptions& options) {
  scene::Gravity& gravity = session.scene().gravity;
  const bool before = gravity.on;
  if (options.constant) {
    gravity.constant = *options.constant;
    gravity.on = *options.constant != 0;
  }
  session.print("Gravity is {} with gravitational constant {:f}. (was {})\n", gravity.on ? "ON" : "OFF",
                gravity.constant, before ? "on" : "off");
}

}  // namespace

extern const Command gravitation_command = make_command<GravitationOptions>(
    {.name = "gravitation",
     .aliases = {"G"},
     .summary = "how strong gravity is, and whether it acts",
     .group = CommandGroup::scene},
    {positional("constant", &GravitationOptions::constant, "0 turns it off")}, run);

}  // namespace lamella::session::commands
