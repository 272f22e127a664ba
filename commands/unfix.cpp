#include "session/fixing.h"
#include "session/session.h"

namespace lamella::session::commands {

namespace {

struct UnfixOptions {
  Elements elements;
};

void run(Session& session, const UnfixOptions& options) {
  const long changed = set_fixed(session, options.elements, false);
  session.counter("unfix_count") = static_cast<double>(changed);
  session.tell("unfixed: {}\n", changed);
}

}  // namespace

extern const Command unfix_command = make_command<UnfixOptions>(
    {.name = "unfix", .summary = "let elements move again", .group = CommandGroup::scene},
    {positional("elements", &UnfixOptions::elements, "vertices, edges or facets").required()}, run);

}  // namespace lamella::session::commands
