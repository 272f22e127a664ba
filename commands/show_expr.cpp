#include "session/show_filter.h"

namespace lamella::session::commands {

namespace {

struct ShowExprOptions {
  Selection elements;
};

void run(Session& session, const ShowExprOptions& options) {
  if (options.elements.generator->kind != language::ElementKind::facet) return;
  show_only(session, options.elements.text);
}

}  // namespace

extern const Command show_expr_command = make_command<ShowExprOptions>(
    {.name = "show_expr", .summary = "which facets pictures show from now on", .group = CommandGroup::output},
    {positional("elements", &ShowExprOptions::elements, "facets where ...; edges are accepted").required()},
    run);

}  // namespace lamella::session::commands
