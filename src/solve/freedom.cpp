#include "solve/freedom.h"

#include <cmath>

#include "film/normals.h"
#include "film/vertex_place.h"
#include "scene/constraint.h"

namespace lamella::solve {

Freedom::Freedom(const film::Film& film, MotionKind kind) : film_(film) {
  if (kind == MotionKind::full) return;
  film_.edit_position_rows() = {};
  kind_.resize(film.vertex_rows(), Kind::free);
  const film::Columns& columns = film.columns(film::ElementKind::vertex);
  const film::Column* const levels = columns.find(scene::constraint_column);
  const film::Column* const boundaries = columns.find(scene::boundary_column);
  for (std::uint32_t v = 0; v < kind_.size(); ++v) {
    const film::VertexPlace place = film::place_of(film, film::Vertex(v));
    // A film that a constraint holds inside cannot follow its normal; there the constraint alone decides.
    const bool held =
        (levels != nullptr && levels->value(v) != 0) || (boundaries != nullptr && boundaries->value(v) != 0);
    if (place.kind == film::PlaceKind::inside && !held) kind_[v] = Kind::along;
    if (place.kind != film::PlaceKind::line) continue;
    const auto is_rim = [&](film::SignedEdge e) { return film.valence(e.edge()) == 1; };
    if (held && is_rim(place.edges[0]) && is_rim(place.edges[1])) {
      kind_[v] = Kind::slides;
      continue;
    }
    kind_[v] = Kind::square;
    const auto [before, after] = place.edges;
    Line line{v, film.head(before).index, film.head(after).index, {}};
    if (film.periodic()) line.shift = film.lattice()->shift(film.wrap(after) - film.wrap(before));
    lines_.push_back(line);
  }
}

void Freedom::renew(std::span<const Vec3> x) {
  if (kind_.empty()) return;
  direction_ = film::area_vectors(film_, x);
  for (Vec3& d : direction_) d = unit(d);
  for (const Line& line : lines_) direction_[line.vertex] = unit(x[line.after] - x[line.before] + line.shift);
}

std::optional<Vec3> Freedom::along_line(std::size_t vertex) const {
  if (kind_.empty() || kind_[vertex] != Kind::square) return std::nullopt;
  return direction_[vertex];
}

std::optional<Vec3> Freedom::sliding_normal(std::size_t vertex) const {
  if (kind_.empty() || kind_[vertex] != Kind::slides) return std::nullopt;
  return direction_[vertex];
}

std::uint32_t Freedom::count(std::size_t vertex) const {
  if (kind_.empty() || kind_[vertex] == Kind::free || kind_[vertex] == Kind::slides) return 3;
  return kind_[vertex] == Kind::along ? 1 : 2;
}

std::array<Vec3, 3> Freedom::directions(std::size_t vertex) const {
  if (kind_.empty() || kind_[vertex] == Kind::free || kind_[vertex] == Kind::slides)
    return {Vec3{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  // Where neither normal nor line has a direction, any will do.
  const Vec3 d = direction_[vertex] == Vec3{} ? Vec3{0, 0, 1} : direction_[vertex];
  if (kind_[vertex] == Kind::along) return {d};
  const double ax = std::abs(d.x);
  const double ay = std::abs(d.y);
  const double az = std::abs(d.z);
  const Vec3 least = ax <= ay && ax <= az ? Vec3{1, 0, 0} : ay <= az ? Vec3{0, 1, 0} : Vec3{0, 0, 1};
  const Vec3 first = unit(cross(d, least));
  return {first, cross(d, first)};
}

void Freedom::restrict(std::span<Vec3> field) const {
  for (std::size_t v = 0; v < kind_.size(); ++v) {
    if (kind_[v] == Kind::free || kind_[v] == Kind::slides) continue;
    const Vec3 part = dot(field[v], direction_[v]) * direction_[v];
    field[v] = kind_[v] == Kind::along ? part : field[v] - part;
  }
}

}  // namespace lamella::solve
