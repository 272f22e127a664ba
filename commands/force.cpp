#include "session/session.h"

namespace lamella::session::commands {

namespace {

struct ForceOptions {
  std::optional<VertexFormulas> formulas;
  bool off = false;
};

void run(Session& session, const ForceOptions& options) {
  scene::Forces& forces = session.scene().forces;
  if (options.off && options.formulas) throw text::Error("a force, or off?", "force (0, 0, -1) or force off");
  if (options.off) {
    forces.force.reset();
  } else if (options.formulas) {
    forces.force = options.formulas->formula;
  } else if (forces.force) {
    session.print("force ({})\n", forces.force->text());
  } else {
    session.print("force off\n");
  }
}

}  // namespace

extern const Command force_command =
    make_command<ForceOptions>({.name = "force",
                                .summary = "a force on the film as evolve moves it, by formulas",
                                .group = CommandGroup::motion},
                               {positional("formulas", &ForceOptions::formulas,
                                           "force for each unit of area, in x, y, z, vx, nx, total_time"),
                                flag("off", &ForceOptions::off, "no force")},
                               run);

}  // namespace lamella::session::commands
