#include "solve/saddle.h"

#include "session/hessian_words.h"

namespace lamella::session::commands {

namespace {

struct SaddleOptions {
  std::optional<double> limit;
};

void run(Session& session, const SaddleOptions& options) {
  HessianWork work(session);
  work.linearise();
  const solve::Departure found = solve::leave_saddle(work.system(), work.positions(),
                                                     options.limit.value_or(HUGE_VAL), session.monitor());
  if (session.monitor().stop_requested()) return;
  if (!found.known)
    throw text::Error("the Hessian has no modes that could be found", "nothing may be free to move");
  session.counter("last_eigenvalue") = found.value;
  if (!(found.value < 0)) {
    session.tell("Lowest eigenvalue {:#.15g}. Not a saddle point.\n", found.value);
    return;
  }
  session.tell("Lowest eigenvalue {:#.15g}\n", found.value);
  work.publish();
  session.tell("{:3}. area: {:#17.15g} energy: {:#17.15g}  scale: {:#g}\n", 1, session.measures().area,
               found.energy, found.scale);
}

}  // namespace

extern const Command saddle_command = make_command<SaddleOptions>(
    {.name = "saddle",
     .summary = "to the lowest energy along the most negative mode, volumes kept",
     .group = CommandGroup::motion},
    {positional("limit", &SaddleOptions::limit, "longest step along the mode; none unless given").above(0)},
    run);

}  // namespace lamella::session::commands
