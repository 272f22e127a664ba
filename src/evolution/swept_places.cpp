#include "evolution/swept_places.h"

#include <bit>
#include <cstdint>

namespace lamella::evolution {

namespace {

using film::ElementKind;
using film::Vec3;

constexpr const char* column_name = "swept_place";
constexpr const char* mark_name = "swept_mark";
constexpr int unused_bits = 11;  // of 64, so that a number tells them all

// A number that hardly any other positions have.
double mark_of(std::span<const Vec3> positions) {
  std::uint64_t mark = positions.size();
  for (const Vec3& p : positions) {
    for (const double value : {p.x, p.y, p.z}) {
      mark = (mark ^ std::bit_cast<std::uint64_t>(value)) * 0x9e3779b97f4a7c15U;
      mark ^= mark >> 29U;
    }
  }
  return static_cast<double>(mark >> unused_bits);
}

film::Column& column_of(film::Columns& columns, const char* name, int width) {
  film::Column* const column = columns.edit(name);
  return column != nullptr ? *column : columns.add(film::real_column(name, 0, width));
}

}  // namespace

void store_swept_places(scene::Scene& scene, std::span<const Vec3> places) {
  film::Columns& columns = scene.film.columns(ElementKind::vertex);
  film::Reals& data = std::get<film::Reals>(column_of(columns, column_name, 3).data);
  for (std::size_t v = 0; v < places.size(); ++v) {
    data[3 * v] = places[v].x;
    data[3 * v + 1] = places[v].y;
    data[3 * v + 2] = places[v].z;
  }
  scene.body_columns.resize(scene.bodies.size());
  film::Reals& mark = std::get<film::Reals>(column_of(scene.body_columns, mark_name, 1).data);
  if (!mark.empty()) mark[0] = mark_of(scene.film.positions());
}

std::optional<std::vector<Vec3>> take_swept_places(scene::Scene& scene) {
  film::Columns& columns = scene.film.columns(ElementKind::vertex);
  const std::span<const double> data = columns.reals(column_name);
  if (data.empty()) return {};
  const std::span<const double> mark = scene.body_columns.reals(mark_name);
  std::optional<std::vector<Vec3>> places;
  if (!mark.empty() && mark[0] == mark_of(scene.film.positions())) {
    places.emplace(data.size() / 3);
    for (std::size_t v = 0; v < places->size(); ++v)
      (*places)[v] = {data[3 * v], data[3 * v + 1], data[3 * v + 2]};
  }
  columns.remove(column_name);
  scene.body_columns.remove(mark_name);
  return places;
}

}  // namespace lamella::evolution
