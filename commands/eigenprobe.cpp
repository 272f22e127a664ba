#include "session/hessian_words.h"

namespace lamella::session::commands {

namespace {

struct ProbeOptions {
  double value = 0;
};

// Two counts a hair apart tell what lies at the value itself.
constexpr double hair = 1e-10;

int below(HessianWork& work, double value) {
  if (!work.system().factorise(-value))
    throw text::Error(fmt::format("the Hessian less {:g} is singular to rounding", value),
                      "probe a little beside it");
  return work.system().negative_modes_with_rigid();
}

void run(Session& session, const ProbeOptions& options) {
  HessianWork work(session);
  work.linearise();
  const double width = hair * std::max(work.system().scale(), std::abs(options.value));
  const int less = below(work, options.value - width);
  const int less_or_equal = below(work, options.value + width);
  session.print("Eigencounts:    {} <,  {} ==,  {} > \n", less, less_or_equal - less,
                static_cast<int>(work.system().mode_count()) - less_or_equal);
}

}  // namespace

extern const Command eigenprobe_command =
    make_command<ProbeOptions>({.name = "eigenprobe",
                                .summary = "how many modes of the Hessian lie below, at and above a value",
                                .group = CommandGroup::measure},
                               {positional("value", &ProbeOptions::value, "0 unless given")}, run);

}  // namespace lamella::session::commands
