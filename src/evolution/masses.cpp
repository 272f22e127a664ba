#include "evolution/masses.h"

namespace lamella::evolution {

using film::Column;
using film::Columns;
using film::ElementKind;
using film::Inheritance;
using film::Reals;
using film::Vec3;

namespace {

Reals& column_data(Columns& columns, const char* name, int width, Inheritance::New on_new) {
  Column* column = columns.edit(name);
  if (column == nullptr) column = &columns.add(film::real_column(name, 0, width, on_new));
  return std::get<Reals>(column->data);
}

}  // namespace

std::vector<double> carried_masses(const film::Film& film, std::span<const energy::VertexLine> lines) {
  std::vector<double> masses(lines.size());
  const std::span<const double> carried = film.columns(ElementKind::vertex).reals("mass");
  bool complete = !carried.empty();
  for (std::size_t v = 0; v < lines.size() && complete; ++v) {
    masses[v] = carried[v];
    complete = carried[v] > 0 || lines[v].area == 0;
  }
  if (!complete) {
    for (std::size_t v = 0; v < lines.size(); ++v) masses[v] = lines[v].area;
  }
  return masses;
}

std::vector<Vec3> velocities(const film::Film& film) {
  std::vector<Vec3> result(film.vertex_rows());
  const std::span<const double> values = film.columns(ElementKind::vertex).reals("velocity");
  if (values.size() != 3 * result.size()) return result;
  for (std::size_t v = 0; v < result.size(); ++v)
    result[v] = {values[3 * v], values[3 * v + 1], values[3 * v + 2]};
  return result;
}

void store_velocities(film::Film& film, std::span<const Vec3> velocities) {
  Reals& velocity = column_data(film.columns(ElementKind::vertex), "velocity", 3, Inheritance::New::mean);
  for (std::size_t v = 0; v < velocities.size(); ++v) {
    for (int axis = 0; axis < 3; ++axis)
      velocity[3 * v + static_cast<std::size_t>(axis)] = velocities[v][axis];
  }
}

void store_motion(film::Film& film, std::span<const double> masses, std::span<const Vec3> velocities) {
  Reals& mass = column_data(film.columns(ElementKind::vertex), "mass", 1, Inheritance::New::blank);
  mass.assign(masses.begin(), masses.end());
  store_velocities(film, velocities);
}

}  // namespace lamella::evolution
