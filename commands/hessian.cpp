#include "session/hessian_words.h"

namespace lamella::session::commands {

namespace {

struct HessianOptions {
  long steps = 1;
};

void run(Session& session, const HessianOptions& options) {
  HessianWork work(session);
  for (long i = options.steps; i > 0; --i) {
    const solve::NewtonStep step = work.method().step(work.positions(), solve::SaddlePolicy::keep);
    const bool moved = step.ending == solve::Ending::step_limit;
    if (!moved && step.ending != solve::Ending::stuck) refuse_hessian_step(step.ending);
    session.tell("{:3}. area: {:#17.15g} energy: {:#17.15g}\n", i, step.area, step.energy);
    tell_negative_modes(session, step);
    if (moved && step.fraction < 1)
      session.tell("The step was cut to {:.3g} of its length.\n", step.fraction);
    session.monitor().progress(options.steps - i + 1, options.steps, step.energy);
    if (!moved) {
      session.tell("No step along Newton's direction does what it should: try hessian_seek, g or relax.\n");
      break;
    }
    if (session.monitor().stop_requested()) break;
  }
  work.publish();
}

}  // namespace

extern const Command hessian_command = make_command<HessianOptions>(
    {.name = "hessian", .summary = "a step of Newton's method, volumes kept", .group = CommandGroup::motion},
    {positional("steps", &HessianOptions::steps, "how many").at_least(0)}, run);

}  // namespace lamella::session::commands
