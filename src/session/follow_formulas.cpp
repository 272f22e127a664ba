#include "session/follow_formulas.h"

#include <numeric>
#include <vector>

#include "scene/constraint_sets.h"
#include "scene/periods.h"
#include "scene/projection.h"
#include "text/error.h"

namespace lamella::session {

namespace {

bool holds_nothing(const scene::Scene& scene) {
  return scene.level_sets.empty() && scene.boundaries.empty();
}

}  // namespace

void follow_constraints(scene::Scene& scene, std::span<const std::uint32_t> vertices) {
  if (holds_nothing(scene)) return;
  scene::bind_formulas(scene);
  const auto fixed = scene.film.columns(film::ElementKind::vertex).flags("fixed");
  for (const std::uint32_t row : vertices) {
    const film::Vertex v(row);
    const bool stays = !fixed.empty() && fixed[row] != 0;  // on a boundary it keeps its parameters
    if (!scene.film.alive(v) || scene::constrain_vertex(scene, v, stays, scene.constraint_tolerance))
      continue;
    throw text::Error("some vertices cannot be put onto their constraints",
                      "constraints that contradict one another, or formulas without a value there");
  }
}

void follow_formulas(scene::Scene& scene) {
  scene::renew_periods(scene);
  if (holds_nothing(scene)) return;
  std::vector<std::uint32_t> all(scene.film.vertex_rows());
  std::iota(all.begin(), all.end(), 0U);
  follow_constraints(scene, all);
}

}  // namespace lamella::session
