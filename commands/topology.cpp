#include "session/session.h"
#include "session/topology_words.h"

namespace lamella::session::commands {

namespace {

struct TopologyOptions {
  bool on = false;
  bool off = false;
  std::optional<std::string> energy;
};

void run(Session& session, const TopologyOptions& options) {
  if (options.on && options.off) throw text::Error("on, or off?", "topology on");
  TopologySwitch& now = session.memory<TopologySwitch>();
  if (options.on || options.off) now.on = options.on;
  if (options.energy) now.keeps_energy = *options.energy == "kept";
  if (!options.on && !options.off && !options.energy)
    session.print("topology {}{}\n", now.on ? "on" : "off", now.keeps_energy ? "" : " energy=lost");
}

}  // namespace

extern const Command topology_command = make_command<TopologyOptions>(
    {.name = "topology",
     .summary = "whether films merge, pinch and swap neighbours as evolve moves them",
     .group = CommandGroup::motion},
    {flag("on", &TopologyOptions::on, "they do, and the mesh is kept within its band"),
     flag("off", &TopologyOptions::off, "they do not"),
     option("energy", &TopologyOptions::energy,
            "kept: what a change of the mesh costs goes into the velocities around it; lost: they are "
            "interpolated")
         .one_of({"kept", "lost"})},
    run);

}  // namespace lamella::session::commands
