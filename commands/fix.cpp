#include "session/fixing.h"
#include "session/session.h"

namespace lamella::session::commands {

namespace {

void run(Session& session, const Fixable& options) {
  const long changed = set_fixed(session, options, true);
  session.counter("fix_count") = static_cast<double>(changed);
  session.tell("fixed: {}\n", changed);
}

}  // namespace

extern const Command fix_command = make_command<Fixable>(
    {.name = "fix", .summary = "keep elements where they are", .group = CommandGroup::scene},
    {positional("elements", &Fixable::elements, "vertices, edges or facets"),
     positional("parameter", &Fixable::parameter, "of the datafile, that may be optimized")},
    run);

}  // namespace lamella::session::commands
