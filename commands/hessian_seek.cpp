#include "session/hessian_words.h"

namespace lamella::session::commands {

namespace {

struct SeekOptions {
  double limit = 1;
};

void run(Session& session, const SeekOptions& options) {
  HessianWork work(session);
  const solve::NewtonStep step = work.method().seek(work.positions(), options.limit);
  if (step.ending == solve::Ending::not_finite || step.ending == solve::Ending::volume_lost)
    refuse_hessian_step(step.ending);
  session.tell("{:3}. area: {:#17.15g} energy: {:#17.15g}  scale: {:#g}\n", 1, step.area, step.energy,
               step.fraction);
  tell_negative_modes(session, step);
  work.publish();
}

}  // namespace

extern const Command hessian_seek_command = make_command<SeekOptions>(
    {.name = "hessian_seek",
     .summary = "to the lowest energy along Newton's direction, volumes kept",
     .group = CommandGroup::motion},
    {positional("limit", &SeekOptions::limit, "at most so many times the full step").above(0)}, run);

}  // namespace lamella::session::commands
