#include "session/fixing.h"
#include "session/session.h"

namespace lamella::session::commands {

namespace {

void run(Session& session, const Fixable& options) {
  const long changed = set_fixed(session, options, false);
  session.counter("unfix_count") = static_cast<double>(changed);
  session.tell("unfixed: {}\n", changed);
}

}  // namespace

extern const Command unfix_command = make_command<Fixable>(
    {.name = "unfix", .summary = "let elements move again", .group = CommandGroup::scene},
    {positional("elements", &Fixable::elements, "vertices, edges or facets"),
     positional("parameter", &Fixable::parameter, "of the datafile, that may be optimized")},
    run);

}  // namespace lamella::session::commands
