#include "scene/constraint_sets.h"
#include "session/attribute_table.h"
#include "session/mesh_commands.h"
#include "surgery/dissolve.h"

namespace lamella::session::commands {

namespace {

struct ZoomOptions {
  long vertex = 0;
  double radius = 0;
};

// Edges that a facet has left have lost their hold: they are fixed, with their ends.
void fix_cut_edges(Session& session, const std::vector<film::Edge>& edges) {
  const AttributeSource source = session.attribute_source();
  for (const film::Edge e : edges) {
    if (!session.scene().film.alive(e)) continue;
    made_column(source, language::ElementKind::edge, "fixed").set(e.index, 0, 1);
    for (const film::Vertex v : session.scene().film.ends(e))
      made_column(source, language::ElementKind::vertex, "fixed").set(v.index, 0, 1);
  }
}

void run(Session& session, const ZoomOptions& options) {
  scene::Scene& scene = session.scene();
  film::Film& film = scene.film;
  if (scene::body_count(scene) > 0) throw text::Error("there are bodies, which cannot be cut");
  const film::Vertex centre =
      options.vertex > 0 ? film.vertex_numbered(static_cast<std::uint32_t>(options.vertex)) : film::Vertex{};
  if (!centre.valid()) throw text::Error(fmt::format("there is no vertex {}", options.vertex));
  const film::Vec3 at = film.position(centre);
  const auto inside = [&](film::Vertex v) { return length(film.position(v) - at) <= options.radius; };
  std::vector<film::Edge> cut;
  for (std::uint32_t i = 0; i < film.triangle_rows(); ++i) {
    const film::Triangle t(i);
    const auto& c = film.corners(t);
    if (!film.alive(t) || std::all_of(c.begin(), c.end(), inside)) continue;
    for (const film::SignedEdge& e : film.edges(t)) cut.push_back(e.edge());
    film.remove(t);
  }
  for (std::uint32_t i = 0; i < film.edge_rows(); ++i) {
    const film::Edge e(i);
    if (film.alive(e) && !(inside(film.ends(e)[0]) && inside(film.ends(e)[1]))) surgery::dissolve(scene, e);
  }
  for (std::uint32_t i = 0; i < film.vertex_rows(); ++i) {
    if (film.alive(film::Vertex(i)) && !inside(film::Vertex(i))) surgery::dissolve(scene, film::Vertex(i));
  }
  fix_cut_edges(session, cut);
  film.compact();
}

}  // namespace

extern const Command zoom_command = make_command<ZoomOptions>(
    {.name = "zoom",
     .aliases = {"Z"},
     .summary = "keep only what is near a vertex",
     .group = CommandGroup::scene},
    {positional("vertex", &ZoomOptions::vertex, "number of the vertex in the middle").required(),
     positional("radius", &ZoomOptions::radius, "what is farther away goes").required().above(0)},
    run);

}  // namespace lamella::session::commands
