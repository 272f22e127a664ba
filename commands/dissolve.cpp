#include "surgery/dissolve.h"

#include "session/mesh_commands.h"

namespace lamella::session::commands {

namespace {

struct DissolveOptions {
  Elements elements;
};

bool dissolve_one(scene::Scene& scene, const language::Element& element) {
  switch (element.kind) {
    case language::ElementKind::vertex:
      return surgery::dissolve(scene, film::Vertex(element.row));
    case language::ElementKind::edge:
      return surgery::dissolve(scene, film::Edge(element.row));
    case language::ElementKind::facet:
      return surgery::dissolve(scene, film::Triangle(element.row));
    case language::ElementKind::body:
      return surgery::dissolve(scene, film::Region{element.row + 1});
  }
  return false;
}

std::string capital(std::string_view word) {
  std::string result(word);
  result.front() = static_cast<char>(result.front() - 'a' + 'A');
  return result;
}

void run(Session& session, const DissolveOptions& options) {
  long count = 0;
  for (const language::Element& element : options.elements.list)
    count += dissolve_one(session.scene(), element) ? 1 : 0;
  session.scene().film.compact();
  const language::ElementKind kind = options.elements.kind;
  session.counter(fmt::format("{}_dissolve_count", language::name_of(kind))) = static_cast<double>(count);
  if (count > 0) session.tell("{} dissolved: {}\n", capital(language::plural_of(kind)), count);
}

}  // namespace

extern const Command dissolve_command = make_command<DissolveOptions>(
    {.name = "dissolve",
     .summary = "take elements out that nothing else is made of, leaving a gap",
     .group = CommandGroup::mesh},
    {positional("elements", &DissolveOptions::elements, "vertices, edges, facets or bodies").required()},
    run);

}  // namespace lamella::session::commands
