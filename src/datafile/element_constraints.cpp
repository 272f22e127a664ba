#include "datafile/element_constraints.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "scene/constraint_sets.h"
#include "scene/projection.h"

namespace lamella::datafile {

namespace {

using film::ElementKind;
using film::Vec3;
using film::Vertex;

constexpr std::array<ElementKind, 3> held_kinds = {ElementKind::facet, ElementKind::edge,
                                                   ElementKind::vertex};

std::array<double, 3> numbers_of(const Vec3& vector) {
  return {vector.x, vector.y, vector.z};
}

const std::vector<std::pair<std::uint32_t, int>>& boundary_rows(const Rows& rows, ElementKind kind) {
  return rows.boundaries[static_cast<std::size_t>(kind)];
}

// What splits an edge inherits from it, what is drawn inside a facet from that.
void reserve_columns(scene::Scene& scene, const Rows& rows) {
  int width = 0;
  bool bounded = false;
  for (const ElementKind kind : held_kinds) {
    width = std::max(width, scene::constraint_width(scene, kind));
    scene::reserve_constraints(scene, kind, width);
    bounded = bounded || !boundary_rows(rows, kind).empty();
    if (bounded) scene::reserve_boundaries(scene, kind);
  }
}

void turn_edges(Reading& reading) {
  film::Column* const column = reading.scene.film.columns(ElementKind::edge).edit(scene::constraint_column);
  if (column == nullptr) return;
  for (const std::uint32_t row : reading.rows.turned_edges) {
    for (int k = 0; k < column->width; ++k) column->set(row, k, -std::abs(column->value(row, k)));
  }
}

// The parameters of what a cut face's centre inherits a boundary from are those of its corners.
void settle_centre(scene::Scene& scene, const scene::Boundary& boundary, Vertex v) {
  std::array<double, 3> parameters = scene::boundary_parameters(scene, v);
  if (!scene::nearest_parameters(scene, boundary, scene.film.position(v), parameters)) return;
  scene::set_boundary_parameters(scene, v, parameters);
  scene.film.move(v, scene::boundary_position(scene, boundary, parameters));
}

}  // namespace

void place_on_boundaries(Reading& reading) {
  scene::bind_formulas(reading.scene);
  Rows& rows = reading.rows;
  rows.parameters.clear();
  for (const auto& [row, number] : boundary_rows(rows, ElementKind::vertex)) {
    const scene::Boundary& boundary = reading.scene.boundaries.at(number);
    Vec3& position = rows.positions[row];
    rows.parameters.push_back(numbers_of(position));
    position = scene::boundary_position(reading.scene, boundary, rows.parameters.back());
    if (is_finite(position)) continue;
    reading.findings.error(reading.tokens.place(rows.of(ElementKind::vertex).spots[row]),
                           fmt::format("boundary {} has no point for the parameters of vertex {}", number,
                                       rows.of(ElementKind::vertex).ids[row]));
  }
}

void add_constraints(Reading& reading) {
  scene::Scene& scene = reading.scene;
  for (const ElementKind kind : held_kinds) {
    for (const auto& [row, number] : reading.rows.constraints[static_cast<std::size_t>(kind)])
      scene::add_constraint(scene, kind, row, number);
    for (const auto& [row, number] : boundary_rows(reading.rows, kind))
      scene::set_boundary(scene, kind, row, number);
  }
  reserve_columns(scene, reading.rows);
  turn_edges(reading);
  std::size_t next = 0;
  for (const auto& [row, number] : boundary_rows(reading.rows, ElementKind::vertex))
    scene::set_boundary_parameters(scene, Vertex(row), reading.rows.parameters[next++]);
}

namespace {

// Whether the vertex is where it belongs. What lies within the tolerance stays as it is: so what was saved on
// its constraints is loaded as it was saved.
bool project_vertex(scene::Scene& scene, std::uint32_t row) {
  const std::vector<int> numbers = scene::constraints_of(scene, ElementKind::vertex, row);
  if (numbers.empty() || scene::boundary_of(scene, ElementKind::vertex, row) != 0) return true;
  Vec3 point = scene.film.position(Vertex(row));
  if (!scene::project_to_level_sets(scene, numbers, row, point, scene.constraint_tolerance)) return false;
  scene.film.move(Vertex(row), point);
  return true;
}

}  // namespace

void project_vertices_of_file(Reading& reading) {
  if (reading.scene.level_sets.empty()) return;
  const Numbering& numbering = reading.rows.of(ElementKind::vertex);
  for (std::uint32_t row = 0; row < numbering.size(); ++row) {
    if (project_vertex(reading.scene, row)) continue;
    reading.findings.warning(
        reading.tokens.place(numbering.spots[row]),
        fmt::format("vertex {} cannot be brought onto its constraints", numbering.ids[row]));
  }
}

void project_centres(Reading& reading) {
  scene::Scene& scene = reading.scene;
  const auto first = static_cast<std::uint32_t>(reading.rows.of(ElementKind::vertex).size());
  for (std::uint32_t row = first; row < scene.film.vertex_rows(); ++row) {
    const auto boundary = scene.boundaries.find(scene::boundary_of(scene, ElementKind::vertex, row));
    if (boundary != scene.boundaries.end()) settle_centre(scene, boundary->second, Vertex(row));
    project_vertex(scene, row);
  }
}

}  // namespace lamella::datafile
