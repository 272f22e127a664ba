#include "scene/constraint_sets.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "scene/projection.h"

namespace lamella::scene {

using film::Column;
using film::ElementKind;
using film::Vec3;
using film::Vertex;

namespace {

const Column* constraints_column(const Scene& scene, ElementKind kind) {
  return scene.film.columns(kind).find(constraint_column);
}

// The column with room for `width` numbers, kept and widened if it is there.
Column& widened(Scene& scene, ElementKind kind, int width) {
  film::Columns& columns = scene.film.columns(kind);
  const Column* old = columns.find(constraint_column);
  if (old != nullptr && old->width >= width) return *columns.edit(constraint_column);
  Column made = film::integer_column(constraint_column, 0, film::Inheritance::New::parent);
  made.width = width;
  made.shape = {width};
  made.resize(columns.rows());
  if (old != nullptr) {
    for (std::uint32_t row = 0; row < columns.rows(); ++row) made.copy_row_of(*old, row, row);
  }
  return columns.add(std::move(made));
}

int slot_of(const Column& column, std::uint32_t row, int number) {
  for (int k = 0; k < column.width; ++k) {
    if (std::abs(static_cast<int>(column.value(row, k))) == std::abs(number)) return k;
  }
  return -1;
}

int free_slot(const Column& column, std::uint32_t row) {
  for (int k = 0; k < column.width; ++k) {
    if (column.value(row, k) == 0) return k;
  }
  return column.width;
}

}  // namespace

std::vector<int> constraints_of(const Scene& scene, ElementKind kind, std::uint32_t row) {
  std::vector<int> numbers;
  if (const Column* const column = constraints_column(scene, kind)) {
    for (int k = 0; k < column->width; ++k) {
      const int number = static_cast<int>(column->value(row, k));
      if (number != 0) numbers.push_back(number);
    }
  }
  if (kind != ElementKind::vertex) return numbers;
  for (const auto& [number, set] : scene.level_sets) {
    if (set.global && std::find(numbers.begin(), numbers.end(), number) == numbers.end())
      numbers.push_back(number);
  }
  return numbers;
}

void add_constraint(Scene& scene, ElementKind kind, std::uint32_t row, int number) {
  if (const Column* const column = constraints_column(scene, kind);
      column != nullptr && slot_of(*column, row, number) >= 0)
    return;
  const Column* const column = constraints_column(scene, kind);
  const int slot = column != nullptr ? free_slot(*column, row) : 0;
  widened(scene, kind, slot + 1).set(row, slot, number);
}

void remove_constraint(Scene& scene, ElementKind kind, std::uint32_t row, int number) {
  Column* const column = scene.film.columns(kind).edit(constraint_column);
  if (column == nullptr) return;
  const int slot = slot_of(*column, row, number);
  if (slot >= 0) column->set(row, slot, 0);
}

bool on_constraint(const Scene& scene, ElementKind kind, std::uint32_t row, int number) {
  const std::vector<int> numbers = constraints_of(scene, kind, row);
  return std::any_of(numbers.begin(), numbers.end(), [&](int n) { return std::abs(n) == number; });
}

void reserve_constraints(Scene& scene, ElementKind kind, int width) {
  if (width > 0) widened(scene, kind, width);
}

int constraint_width(const Scene& scene, ElementKind kind) {
  const Column* const column = constraints_column(scene, kind);
  return column != nullptr ? column->width : 0;
}

int boundary_of(const Scene& scene, ElementKind kind, std::uint32_t row) {
  const Column* const column = scene.film.columns(kind).find(boundary_column);
  return column != nullptr ? static_cast<int>(column->value(row)) : 0;
}

void reserve_boundaries(Scene& scene, ElementKind kind) {
  film::Columns& columns = scene.film.columns(kind);
  if (columns.find(boundary_column) == nullptr)
    columns.add(film::integer_column(boundary_column, 0, film::Inheritance::New::parent));
}

void set_boundary(Scene& scene, ElementKind kind, std::uint32_t row, int number) {
  reserve_boundaries(scene, kind);
  scene.film.columns(kind).edit(boundary_column)->set(row, 0, number);
}

std::array<double, 3> boundary_parameters(const Scene& scene, Vertex v) {
  const Column* const column = scene.film.columns(ElementKind::vertex).find(parameter_column);
  if (column == nullptr) return {};
  return {column->value(v.index, 0), column->value(v.index, 1), column->value(v.index, 2)};
}

void set_boundary_parameters(Scene& scene, Vertex v, const std::array<double, 3>& parameters) {
  film::Columns& columns = scene.film.columns(ElementKind::vertex);
  if (columns.find(parameter_column) == nullptr) {
    columns.add(film::real_column(parameter_column, 0, 3, film::Inheritance::New::mean));
  }
  Column* const column = columns.edit(parameter_column);
  for (int k = 0; k < 3; ++k) column->set(v.index, k, parameters[static_cast<std::size_t>(k)]);
}

namespace {

void bind_integrand(std::optional<EdgeIntegrand>& integrand, const Scene& scene) {
  if (!integrand) return;
  for (language::Formula& formula : *integrand) formula.bind(scene.variables, present_gravity(scene));
}

}  // namespace

void bind_formulas(Scene& scene) {
  for (auto& [number, set] : scene.level_sets) {
    set.formula.bind(scene.variables, present_gravity(scene));
    bind_integrand(set.energy, scene);
    bind_integrand(set.content, scene);
  }
  for (auto& [number, boundary] : scene.boundaries) {
    for (language::Formula& formula : boundary.position)
      formula.bind(scene.variables, present_gravity(scene));
    bind_integrand(boundary.energy, scene);
    bind_integrand(boundary.content, scene);
  }
  for (Quantity& quantity : scene.quantities) {
    for (MethodInstance& instance : quantity.methods) {
      instance.scalar.bind(scene.variables, present_gravity(scene));
      for (language::Formula& formula : instance.field) formula.bind(scene.variables, present_gravity(scene));
    }
  }
}

}  // namespace lamella::scene
