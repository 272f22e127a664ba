#include "session/session.h"

namespace lamella::session::commands {

namespace {

void run(Session& session) {
  const double facets = session.counter("step_facets");
  if (!(facets > 0))
    throw text::Error("no step has been timed yet", "evolve 100 makes a hundred, which timing then tells of");
  const double whole = session.counter("step_ms");
  const auto row = [&](const char* name, double ms) {
    session.print("{:8} {:10.4f} {:14.2f} {:7.1f}\n", name, ms, 1e6 * ms / facets, 100 * ms / whole);
  };
  session.print("{:8} {:>10} {:>14} {:>7}\n", "part", "ms a step", "ns a facet", "%");
  row("forces", session.counter("step_forces_ms"));
  row("volumes", session.counter("step_volumes_ms"));
  row("surgery", session.counter("step_surgery_ms"));
  row("other", session.counter("step_other_ms"));
  row("step", whole);
}

}  // namespace

extern const Command timing_command =
    make_command({.name = "timing",
                  .summary = "where the time of the last evolve's steps went",
                  .group = CommandGroup::motion},
                 run);

}  // namespace lamella::session::commands
