#include "surgery/burst.h"

#include "session/mesh_commands.h"
#include "session/topology_words.h"

namespace lamella::session::commands {

namespace {

struct BurstOptions {
  Elements elements;
};

std::optional<surgery::Event> burst_one(scene::Scene& scene, const language::Element& element) {
  if (element.kind == language::ElementKind::body)
    return surgery::burst_body(scene, film::Region{element.row + 1});
  return surgery::burst_sheet(scene, film::Triangle(element.row));
}

void run(Session& session, const BurstOptions& options) {
  const language::ElementKind kind = options.elements.kind;
  if (kind != language::ElementKind::body && kind != language::ElementKind::facet)
    throw text::Error("only bodies and films burst",
                      "burst body[1], or a film by one of its facets: burst facet[5]");
  std::vector<surgery::Event> events;
  for (const language::Element& element : options.elements.list) {
    if (const auto event = burst_one(session.scene(), element)) events.push_back(*event);
  }
  session.counter("burst_count") = static_cast<double>(events.size());
  finish_topology(session, std::move(events));
}

}  // namespace

extern const Command burst_command = make_command<BurstOptions>(
    {.name = "burst",
     .summary = "break a film between borders, or all films of a body to a neighbour",
     .group = CommandGroup::mesh},
    {positional("elements", &BurstOptions::elements, "bodies, or facets of the films").required()}, run);

}  // namespace lamella::session::commands
