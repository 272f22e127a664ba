#include "session/tables.h"

#include <fmt/format.h>

namespace lamella::session {

std::string counts_row(const scene::Scene& scene) {
  const film::Film& film = scene.film;
  return fmt::format("Vertices: {}  Edges: {}  Facets: {}  Bodies: {}  Facetedges: {}\n", film.vertex_count(),
                     film.edge_count(), scene::facet_count(scene), scene::body_count(scene),
                     3 * film.triangle_count());
}

std::string volume_table(const scene::Scene& scene, const energy::Measures& measures) {
  std::string table = "Body          target volume           actual volume          pressure\n";
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    const scene::Body& body = scene.bodies[b];
    if (body.absent) continue;
    const std::string target =
        body.target_volume ? fmt::format("{:.15g}", *body.target_volume) : "------------";
    const double pressure = body.fixed_pressure.value_or(body.pressure);
    table +=
        fmt::format("{:3} {:>23} {:23.15g} {:17.15g}\n", b + 1, target, measures.volumes[b + 1], pressure);
  }
  return table;
}

}  // namespace lamella::session
