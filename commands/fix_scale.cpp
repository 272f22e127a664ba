#include "session/session.h"

namespace lamella::session::commands {

namespace {

struct FixScaleOptions {
  std::optional<double> scale;
};

void run(Session& session, const FixScaleOptions& options) {
  scene::DescentScale& scale = session.scene().scale;
  scale.fixed = options.scale || !scale.fixed;
  if (options.scale) scale.value = *options.scale;
  if (scale.fixed) {
    session.tell("Scale fixed at {:g}.\n", scale.value);
  } else {
    session.tell("Scale optimizing.\n");
  }
}

}  // namespace

extern const Command fix_scale_command = make_command<FixScaleOptions>(
    {.name = "fix_scale",
     .aliases = {"m"},
     .summary = "fix the scale of descent steps, or let each step find its own again",
     .group = CommandGroup::motion},
    {positional("scale", &FixScaleOptions::scale, "motion per unit of force; without it the mode is toggled")
         .above(0)},
    run);

}  // namespace lamella::session::commands
