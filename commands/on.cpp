#include "session/session.h"
#include "session/topology_words.h"

namespace lamella::session::commands {

namespace {

struct OnOptions {
  std::string event;
  std::optional<Commands> commands;
  bool off = false;
};

void run(Session& session, const OnOptions& options) {
  auto& hooks = session.memory<EventHooks>().commands;
  if (options.off) {
    hooks.erase(options.event);
  } else if (options.commands) {
    hooks[options.event] = options.commands->block;
  } else {
    session.print("on {} {}\n", options.event, hooks.contains(options.event) ? "runs commands" : "off");
  }
}

}  // namespace

extern const Command on_command = make_command<OnOptions>(
    {.name = "on", .summary = "run commands when films change their topology", .group = CommandGroup::motion},
    {positional("event", &OnOptions::event, "what happens")
         .required()
         .one_of({"t1", "vanish", "pinch", "pop", "merge", "burst", "split", "join", "birth"}),
     positional("commands", &OnOptions::commands, "what runs then, in braces"),
     flag("off", &OnOptions::off, "nothing runs any more")},
    run);

}  // namespace lamella::session::commands
