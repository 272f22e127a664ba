#include "session/session.h"
#include "session/topology_words.h"

namespace lamella::session::commands {

namespace {

struct TopologyOptions {
  bool on = false;
  bool off = false;
};

void run(Session& session, const TopologyOptions& options) {
  if (options.on && options.off) throw text::Error("on, or off?", "topology on");
  bool& follows = session.memory<TopologySwitch>().on;
  if (options.on || options.off) {
    follows = options.on;
  } else {
    session.print("topology {}\n", follows ? "on" : "off");
  }
}

}  // namespace

extern const Command topology_command = make_command<TopologyOptions>(
    {.name = "topology",
     .summary = "whether films merge, pinch and swap neighbours as evolve moves them",
     .group = CommandGroup::motion},
    {flag("on", &TopologyOptions::on, "they do, and the mesh is kept within its band"),
     flag("off", &TopologyOptions::off, "they do not")},
    run);

}  // namespace lamella::session::commands
