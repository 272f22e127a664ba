#include "session/follow_constraints.h"

#include <numeric>
#include <vector>

#include "scene/constraint_sets.h"
#include "scene/projection.h"
#include "text/error.h"

namespace lamella::session {

namespace {

bool holds_nothing(const scene::Scene& scene) {
  return scene.level_sets.empty() && scene.boundaries.empty();
}

// A fixed vertex keeps its parameters on a boundary.
bool follow(scene::Scene& scene, film::Vertex v, bool fixed) {
  film::Vec3 point = scene.film.position(v);
  const int number = scene::boundary_of(scene, film::ElementKind::vertex, v.index);
  bool arrived = true;
  if (const auto boundary = scene.boundaries.find(number); boundary != scene.boundaries.end()) {
    std::array<double, 3> parameters = scene::boundary_parameters(scene, v);
    if (!fixed) arrived = scene::nearest_parameters(scene, boundary->second, point, parameters);
    scene::set_boundary_parameters(scene, v, parameters);
    point = scene::boundary_position(scene, boundary->second, parameters);
  } else {
    const std::vector<int> numbers = scene::constraints_of(scene, film::ElementKind::vertex, v.index);
    if (numbers.empty()) return true;
    arrived = scene::project_to_level_sets(scene, numbers, v.index, point, scene.constraint_tolerance);
  }
  if (arrived) scene.film.move(v, point);
  return arrived;
}

}  // namespace

void follow_constraints(scene::Scene& scene, std::span<const std::uint32_t> vertices) {
  if (holds_nothing(scene)) return;
  scene::bind_formulas(scene);
  const auto fixed = scene.film.columns(film::ElementKind::vertex).flags("fixed");
  for (const std::uint32_t row : vertices) {
    if (!scene.film.alive(film::Vertex(row)) ||
        follow(scene, film::Vertex(row), !fixed.empty() && fixed[row] != 0))
      continue;
    throw text::Error("some vertices cannot be put onto their constraints",
                      "constraints that contradict one another, or formulas without a value there");
  }
}

void follow_constraints(scene::Scene& scene) {
  if (holds_nothing(scene)) return;
  std::vector<std::uint32_t> all(scene.film.vertex_rows());
  std::iota(all.begin(), all.end(), 0U);
  follow_constraints(scene, all);
}

}  // namespace lamella::session
