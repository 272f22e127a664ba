#include "session/mesh_commands.h"

namespace lamella::session::commands {

namespace {

struct DeleteOptions {
  Selection elements;
};

void run(Session& session, const DeleteOptions& options) {
  const language::ElementKind kind = options.elements.generator->kind;
  const bool edges = kind == language::ElementKind::edge;
  if (!edges && kind != language::ElementKind::facet) {
    throw text::Error("only edges and facets can be deleted",
                      "dissolve takes out vertices without edges, and bodies");
  }
  const long count = collapse_selected(session, *options.elements.generator);
  if (count > 0) session.tell("{} deleted: {}\n", edges ? "Edges" : "Facets", count);
}

}  // namespace

extern const Command delete_command = make_command<DeleteOptions>(
    {.name = "delete", .summary = "collapse edges, or facets, closing the gap", .group = CommandGroup::mesh},
    {positional("elements", &DeleteOptions::elements, "edges or facets").required()}, run);

}  // namespace lamella::session::commands
