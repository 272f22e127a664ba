#include "surgery/pop.h"

#include "session/mesh_commands.h"
#include "session/topology_words.h"
#include "surgery/pop_strings.h"

namespace lamella::session::commands {

namespace {

struct PopOptions {
  Elements elements;
};

surgery::PopReport pop(scene::Scene& scene, const Elements& elements) {
  if (elements.kind == language::ElementKind::vertex) {
    std::vector<film::Vertex> vertices;
    for (const language::Element& element : elements.list) vertices.emplace_back(element.row);
    return scene.strings.on ? surgery::pop_string_vertices(scene, vertices)
                            : surgery::pop_vertices(scene, vertices);
  }
  std::vector<film::Edge> edges;
  for (const language::Element& element : elements.list) edges.emplace_back(element.row);
  return surgery::pop_edges(scene, edges);
}

void run(Session& session, const PopOptions& options) {
  const language::ElementKind kind = options.elements.kind;
  if (kind != language::ElementKind::vertex && kind != language::ElementKind::edge)
    throw text::Error("only vertices and edges can be popped",
                      "a film is taken out by burst: burst facet[5]");
  const surgery::PopReport report = pop(session.scene(), options.elements);
  finish_topology(session, report.events);
  session.counter("vertex_pop_count") = static_cast<double>(report.vertices);
  session.counter("edge_pop_count") = static_cast<double>(report.edges);
  session.counter("pop_count") = static_cast<double>(report.vertices);
}

}  // namespace

extern const Command pop_command = make_command<PopOptions>(
    {.name = "pop",
     .summary = "resolve chosen vertices and edges that no soap film keeps",
     .group = CommandGroup::mesh},
    {positional("elements", &PopOptions::elements, "vertices or edges").required()}, run);

}  // namespace lamella::session::commands
