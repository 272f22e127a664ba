#include "solve/freedom.h"

#include "film/normals.h"
#include "film/vertex_place.h"

namespace lamella::solve {

Freedom::Freedom(const film::Film& film, MotionKind kind) : film_(film) {
  if (kind == MotionKind::full) return;
  film_.edit_position_rows() = {};
  kind_.resize(film.vertex_rows(), Kind::free);
  for (std::uint32_t v = 0; v < kind_.size(); ++v) {
    const film::VertexPlace place = film::place_of(film, film::Vertex(v));
    if (place.kind == film::PlaceKind::inside) kind_[v] = Kind::along;
    if (place.kind != film::PlaceKind::line) continue;
    kind_[v] = Kind::square;
    lines_.push_back({v, place.neighbours[0].index, place.neighbours[1].index});
  }
}

void Freedom::renew(std::span<const Vec3> x) {
  if (kind_.empty()) return;
  direction_ = film::area_vectors(film_, x);
  for (Vec3& d : direction_) d = unit(d);
  for (const Line& line : lines_) direction_[line.vertex] = unit(x[line.after] - x[line.before]);
}

void Freedom::restrict(std::span<Vec3> field) const {
  for (std::size_t v = 0; v < kind_.size(); ++v) {
    if (kind_[v] == Kind::free) continue;
    const Vec3 part = dot(field[v], direction_[v]) * direction_[v];
    field[v] = kind_[v] == Kind::along ? part : field[v] - part;
  }
}

}  // namespace lamella::solve
