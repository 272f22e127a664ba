#include "scene/projection.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace lamella::scene {

using film::EdgeEnd;
using film::ElementKind;
using film::Vec3;
using film::Vertex;

namespace {

constexpr int most_steps = 40;
constexpr int most_constraints = 3;

Vec3 vector_of(const std::array<double, 3>& a) {
  return {a[0], a[1], a[2]};
}

// Solves the small symmetric system (J J^T) m = r for up to three rows by elimination with pivots; rows that
// depend on others get 0.
void solve_small(int n, std::array<std::array<double, 3>, 3> a, std::array<double, 3>& r) {
  std::array<bool, 3> done{};
  const double scale = std::max({a[0][0], a[1][1], a[2][2], 1e-300});
  for (int round = 0; round < n; ++round) {
    int pivot = -1;
    for (int i = 0; i < n; ++i) {
      const auto k = static_cast<std::size_t>(i);
      if (!done[k] &&
          (pivot < 0 || a[k][k] > a[static_cast<std::size_t>(pivot)][static_cast<std::size_t>(pivot)]))
        pivot = i;
    }
    const auto p = static_cast<std::size_t>(pivot);
    done[p] = true;
    if (a[p][p] < 1e-12 * scale) {
      r[p] = 0;
      for (std::size_t j = 0; j < 3; ++j) a[p][j] = a[j][p] = 0;
      continue;
    }
    for (std::size_t i = 0; i < static_cast<std::size_t>(n); ++i) {
      if (i == p) continue;
      const double factor = a[i][p] / a[p][p];
      for (std::size_t j = 0; j < static_cast<std::size_t>(n); ++j) a[i][j] -= factor * a[p][j];
      r[i] -= factor * r[p];
    }
    r[p] /= a[p][p];
    const double inverse = 1 / a[p][p];
    for (std::size_t j = 0; j < static_cast<std::size_t>(n); ++j) a[p][j] *= inverse;
    a[p][p] = 1;
  }
}

}  // namespace

bool violated(const LevelSet& set, double value) {
  return set.sense == Sense::equal || (set.sense == Sense::nonnegative ? value < 0 : value > 0);
}

std::vector<double> attributes_of(const film::Film& film, const language::Formula& formula, ElementKind kind,
                                  std::uint32_t row) {
  std::vector<double> values;
  for (const std::string& name : formula.attributes()) {
    const film::Column* const column = film.columns(kind).find(name);
    values.push_back(column != nullptr ? column->value(row) : 0.0);
  }
  return values;
}

Level level_at(const Scene& scene, const LevelSet& set, const Vec3& point, std::uint32_t vertex) {
  const std::array<double, 3> at{point.x, point.y, point.z};
  std::vector<double> attributes;
  if (!set.formula.attributes().empty())
    attributes = attributes_of(scene.film, set.formula, ElementKind::vertex, vertex);
  const language::Jet jet = set.formula.gradient({at, scene.time, attributes});
  return {jet.value, vector_of(jet.gradient)};
}

double level(const Scene& scene, const LevelSet& set, Vertex v) {
  return level_at(scene, set, scene.film.position(v), v.index).value;
}

bool project_to_level_sets(const Scene& scene, std::span<const int> numbers, std::uint32_t vertex,
                           Vec3& point, double tolerance) {
  double before = HUGE_VAL;
  for (int step = 0; step < most_steps; ++step) {
    std::array<Level, most_constraints> levels;
    int active = 0;
    double distance = 0;
    bool tolerable = true;
    for (const int number : numbers) {
      const auto at = scene.level_sets.find(std::abs(number));
      if (at == scene.level_sets.end() || active == most_constraints) continue;
      const Level found = level_at(scene, at->second, point, vertex);
      if (!std::isfinite(found.value)) return false;
      if (!violated(at->second, found.value)) continue;
      tolerable = tolerable && std::abs(found.value) <= tolerance;
      distance = std::max(distance, std::abs(found.value) / std::max(length(found.gradient), 1e-300));
      levels[static_cast<std::size_t>(active++)] = found;
    }
    const double rounding = 4e-16 * (std::abs(point.x) + std::abs(point.y) + std::abs(point.z) + 1e-300);
    if (active == 0 || tolerable || distance <= rounding || (distance < 100 * rounding && distance >= before))
      return true;
    before = distance;
    std::array<std::array<double, 3>, 3> gram{};
    std::array<double, 3> multipliers{};
    for (int i = 0; i < active; ++i) {
      const auto a = static_cast<std::size_t>(i);
      multipliers[a] = -levels[a].value;
      for (int j = 0; j < active; ++j) {
        gram[a][static_cast<std::size_t>(j)] =
            dot(levels[a].gradient, levels[static_cast<std::size_t>(j)].gradient);
      }
    }
    solve_small(active, gram, multipliers);
    for (int i = 0; i < active; ++i)
      point += multipliers[static_cast<std::size_t>(i)] * levels[static_cast<std::size_t>(i)].gradient;
    if (!is_finite(point)) return false;
  }
  return false;
}

std::array<double, 3> shares(std::span<const Vec3> vectors, const Vec3& vector) {
  std::array<std::array<double, 3>, 3> gram{};
  std::array<double, 3> result{};
  for (std::size_t i = 0; i < vectors.size(); ++i) {
    result[i] = dot(vectors[i], vector);
    for (std::size_t j = 0; j < vectors.size(); ++j) gram[i][j] = dot(vectors[i], vectors[j]);
  }
  solve_small(static_cast<int>(vectors.size()), gram, result);
  return result;
}

BoundaryPoint boundary_point(const Scene& scene, const Boundary& boundary,
                             const std::array<double, 3>& parameters) {
  BoundaryPoint point;
  for (int axis = 0; axis < 3; ++axis) {
    const language::Formula& formula = boundary.position[static_cast<std::size_t>(axis)];
    if (!formula) continue;
    const language::Jet jet = formula.gradient({parameters, scene.time, {}});
    point.position[axis] = jet.value;
    for (std::size_t k = 0; k < static_cast<std::size_t>(boundary.parameters); ++k)
      point.tangents[k][axis] = jet.gradient[k];
  }
  return point;
}

Vec3 boundary_position(const Scene& scene, const Boundary& boundary,
                       const std::array<double, 3>& parameters) {
  return boundary_point(scene, boundary, parameters).position;
}

double approach_parameters(const Scene& scene, const Boundary& boundary, const Vec3& target,
                           std::array<double, 3>& parameters, int steps) {
  const auto n = static_cast<std::size_t>(boundary.parameters);
  double size = HUGE_VAL;
  for (int step = 0; step < steps; ++step) {
    const BoundaryPoint at = boundary_point(scene, boundary, parameters);
    const Vec3 miss = target - at.position;
    std::array<std::array<double, 3>, 3> gram{};
    std::array<double, 3> change{};
    for (std::size_t i = 0; i < n; ++i) {
      change[i] = dot(at.tangents[i], miss);
      for (std::size_t j = 0; j < n; ++j) gram[i][j] = dot(at.tangents[i], at.tangents[j]);
    }
    solve_small(boundary.parameters, gram, change);
    size = 0;
    for (std::size_t i = 0; i < n; ++i) {
      parameters[i] += change[i];
      const double part = std::abs(change[i]) / (1 + std::abs(parameters[i]));
      size = size >= part ? size : part;  // not a number stays
    }
    if (!std::isfinite(size)) return NAN;
  }
  return size;
}

bool nearest_parameters(const Scene& scene, const Boundary& boundary, const Vec3& target,
                        std::array<double, 3>& parameters) {
  double before = HUGE_VAL;
  for (int step = 0; step < most_steps; ++step) {
    const double size = approach_parameters(scene, boundary, target, parameters, 1);
    if (std::isnan(size)) return false;
    if (size < 1e-15 || (size < 1e-12 && size >= before)) return true;
    before = size;
  }
  return before < 1e-8;
}

int orthonormalise(std::span<Vec3> vectors) {
  int count = 0;
  for (const Vec3& given : vectors) {
    Vec3 v = given;
    for (int i = 0; i < count; ++i)
      v -= dot(v, vectors[static_cast<std::size_t>(i)]) * vectors[static_cast<std::size_t>(i)];
    if (length(v) <= 1e-8 * length(given) || length(given) == 0) continue;
    vectors[static_cast<std::size_t>(count++)] = unit(v);
  }
  return count;
}

namespace {

// As many steps as files written elsewhere expect: for the middle of a short edge that is near enough to the
// nearest point, and whatever the parameters, the vertex lies on its boundary.
constexpr int steps_to_middle = 5;

// The parameters of the vertex at the head of the boundary edge that begins here: what splits an edge is the
// tail of its second half. Parameters may jump where a curve closes, so those of one end are the start, not
// the mean of both.
std::array<double, 3> parameters_ahead(const Scene& scene, Vertex v, int boundary) {
  std::array<double, 3> parameters = boundary_parameters(scene, v);
  scene.film.for_each_end(v, [&](EdgeEnd end) {
    const film::SignedEdge outward = end.outward();
    const Vertex neighbour = scene.film.head(outward);
    const bool along = !outward.reversed() &&
                       boundary_of(scene, ElementKind::edge, outward.edge().index) == boundary &&
                       boundary_of(scene, ElementKind::vertex, neighbour.index) == boundary;
    if (along) parameters = boundary_parameters(scene, neighbour);
  });
  return parameters;
}

// Of a vertex between two others of its boundary.
bool find_parameters(const Scene& scene, const Boundary& boundary, int number, Vertex v,
                     std::array<double, 3>& parameters) {
  parameters = boundary_parameters(scene, v);
  if (scene.interpolate_parameters) return true;
  parameters = parameters_ahead(scene, v, number);
  return !std::isnan(
      approach_parameters(scene, boundary, scene.film.position(v), parameters, steps_to_middle));
}

}  // namespace

void settle_vertices(Scene& scene, std::uint32_t first) {
  // Inherited from an edge that runs backwards along a constraint, a number is negative, which is nothing to
  // a vertex.
  const auto unsign_constraints = [](Scene& of, std::uint32_t row) {
    film::Column* const column = of.film.columns(ElementKind::vertex).edit(constraint_column);
    for (int k = 0; column != nullptr && k < column->width; ++k) {
      if (column->value(row, k) < 0) column->set(row, k, -column->value(row, k));
    }
  };
  const bool any = !scene.boundaries.empty() || !scene.level_sets.empty();
  if (!any) return;
  const film::Film& film = scene.film;
  for (std::uint32_t row = first; row < film.vertex_rows(); ++row) {
    const Vertex v(row);
    if (!film.alive(v)) continue;
    const auto boundary = scene.boundaries.find(boundary_of(scene, ElementKind::vertex, row));
    if (boundary != scene.boundaries.end()) {
      std::array<double, 3> parameters{};
      if (!find_parameters(scene, boundary->second, boundary->first, v, parameters)) continue;
      set_boundary_parameters(scene, v, parameters);
      scene.film.move(v, boundary_position(scene, boundary->second, parameters));
      continue;
    }
    unsign_constraints(scene, row);
    const std::vector<int> numbers = constraints_of(scene, ElementKind::vertex, row);
    Vec3 point = film.position(v);
    if (!numbers.empty() && project_to_level_sets(scene, numbers, row, point, scene.constraint_tolerance))
      scene.film.move(v, point);
  }
}

bool constrain_vertex(Scene& scene, Vertex v, bool keep_parameters, double tolerance) {
  Vec3 point = scene.film.position(v);
  const auto boundary = scene.boundaries.find(boundary_of(scene, ElementKind::vertex, v.index));
  if (boundary != scene.boundaries.end()) {
    std::array<double, 3> parameters = boundary_parameters(scene, v);
    const bool found = keep_parameters || nearest_parameters(scene, boundary->second, point, parameters);
    set_boundary_parameters(scene, v, parameters);
    scene.film.move(v, boundary_position(scene, boundary->second, parameters));
    return found;
  }
  const std::vector<int> numbers = constraints_of(scene, ElementKind::vertex, v.index);
  if (numbers.empty()) return true;
  const bool found = project_to_level_sets(scene, numbers, v.index, point, tolerance);
  scene.film.move(v, point);
  return found;
}

bool constrain_vertices(Scene& scene) {
  if (scene.boundaries.empty() && scene.level_sets.empty()) return true;
  bind_formulas(scene);
  const auto fixed = scene.film.columns(ElementKind::vertex).flags("fixed");
  bool all = true;
  for (std::uint32_t row = 0; row < scene.film.vertex_rows(); ++row) {
    const Vertex v(row);
    if (!scene.film.alive(v)) continue;
    const bool stays = !fixed.empty() && fixed[row] != 0;
    const bool rides = scene.boundaries.contains(boundary_of(scene, ElementKind::vertex, row));
    if (stays && !rides) continue;
    all = constrain_vertex(scene, v, stays) && all;
  }
  return all;
}

}  // namespace lamella::scene
