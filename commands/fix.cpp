#include "session/fixing.h"
#include "session/session.h"

namespace lamella::session::commands {

namespace {

struct FixOptions {
  Elements elements;
};

void run(Session& session, const FixOptions& options) {
  const long changed = set_fixed(session, options.elements, true);
  session.counter("fix_count") = static_cast<double>(changed);
  session.tell("fixed: {}\n", changed);
}

}  // namespace

extern const Command fix_command = make_command<FixOptions>(
    {.name = "fix", .summary = "keep elements where they are", .group = CommandGroup::scene},
    {positional("elements", &FixOptions::elements, "vertices, edges or facets").required()}, run);

}  // namespace lamella::session::commands
