#include "session/mesh_commands.h"

#include "scene/constraint_sets.h"

namespace lamella::session {

using language::Element;
using language::ElementKind;

void check_film(Session& session, std::string_view what) {
  if (!session.scene().empty()) return;
  throw text::Error(fmt::format("there is no film {}", what), "load a datafile first: load \"cube.fe\"");
}

void finish_surgery(Session& session) {
  scene::Scene& scene = session.scene();
  scene.film.compact();
  if (!scene.level_sets.empty() || !scene.boundaries.empty()) scene::constrain_vertices(scene);
}

long collapse_selected(Session& session, const language::Generator& generator) {
  scene::Scene& scene = session.scene();
  const bool edges = generator.kind == ElementKind::edge;
  long collapsed = 0;
  for_each_element(generator, session.evaluation(), [&](const Element& element) {
    const surgery::Collapse outcome = edges ? surgery::collapse_edge(scene, film::Edge(element.row))
                                            : surgery::collapse_facet(scene, film::Triangle(element.row));
    if (outcome == surgery::Collapse::done) ++collapsed;
    return !session.monitor().stop_requested();
  });
  finish_surgery(session);
  session.counter(edges ? "edge_delete_count" : "facet_delete_count") = static_cast<double>(collapsed);
  return collapsed;
}

}  // namespace lamella::session
