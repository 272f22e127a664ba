#include <algorithm>
#include <cmath>

#include "energy/mesh_quality.h"
#include "energy/plateau.h"
#include "session/session.h"
#include "session/tables.h"

namespace lamella::session::commands {

namespace {

// The largest relative error among the volumes with a target.
double volume_error(const scene::Scene& scene, const energy::Measures& measures) {
  double worst = 0;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    if (!scene.bodies[b].fixed_volume()) continue;
    worst = std::max(worst, std::abs(measures.volumes[b + 1] / *scene.bodies[b].target_volume - 1));
  }
  return worst;
}

void run(Session& session) {
  const scene::Scene& scene = session.scene();
  const energy::Measures& measures = session.measures();
  session.print("Scene: {}\n{}", scene.name.empty() ? "(none)" : scene.name, counts_row(scene));
  if (scene.empty()) return;
  session.print("Energy: {:.15g}  Area: {:.15g}  Time: {:g}\n", measures.energy, measures.area, scene.time);
  if (scene.has_fixed_volume()) {
    session.print("Volumes: {}, largest relative error {:.2g}\n", scene.keep_volumes ? "kept" : "free",
                  volume_error(scene, measures));
  }
  const energy::EdgeLengths edges = energy::edge_lengths(scene.film);
  session.print("Edges: {:.4g} to {:.4g}  Smallest angle: {:.2f} degrees\n", edges.shortest, edges.longest,
                energy::smallest_angle(scene.film) * 180 / M_PI);
  const energy::PlateauAngles angles = energy::plateau_angles(scene.film);
  if (angles.triple.angles > 0)
    session.print("Triple lines: rms {:.4f} degrees off 120\n", angles.triple.rms);
  if (angles.quad.angles > 0)
    session.print("Quad points: rms {:.4f} degrees off 109.4712\n", angles.quad.rms);
  session.print("Memory: {:.1f} bytes a facet for the film\n",
                static_cast<double>(scene.film.bytes_with_columns()) /
                    std::max(1.0, static_cast<double>(scene.film.triangle_count())));
}

}  // namespace

extern const Command report_command =
    make_command({.name = "report",
                  .aliases = {"i"},
                  .summary = "what there is to know about the scene at a glance",
                  .group = CommandGroup::measure},
                 run);

}  // namespace lamella::session::commands
