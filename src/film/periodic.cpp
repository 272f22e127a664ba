// What Film does where space is periodic.
#include <algorithm>

#include "film/film.h"

namespace lamella::film {

void Film::set_lattice(const Lattice& lattice) {
  lattice_ = std::make_shared<const Lattice>(lattice);
  if (columns_[1].find(wrap_column) != nullptr) return;
  Column column = integer_column(wrap_column);
  column.shape = {3};
  column.width = 3;
  columns_[1].add(std::move(column));
}

Wrap Film::wrap(SignedEdge e) const {
  const auto& data = std::get<Integers>(columns_[1].find(wrap_column)->data);
  const std::size_t first = 3 * std::size_t{e.edge().index};
  const Wrap w{{data[first], data[first + 1], data[first + 2]}};
  return e.reversed() ? -w : w;
}

void Film::set_wrap(Edge e, const Wrap& wrap) {
  auto& data = std::get<Integers>(columns_[1].edit(wrap_column)->data);
  std::copy(wrap.times.begin(), wrap.times.end(), data.begin() + 3 * std::ptrdiff_t{e.index});
}

void Film::aim(SignedEdge e, const Vec3& vector) {
  if (!lattice_) return;
  const Wrap w = lattice_->nearest(vector - (position(head(e)) - position(tail(e))));
  set_wrap(e.edge(), e.reversed() ? -w : w);
}

std::array<Wrap, 3> Film::corner_wraps(Triangle t) const {
  const auto& e = edges(t);
  const Wrap second = wrap(e[0]);
  return {Wrap{}, second, second + wrap(e[1])};
}

std::array<Vec3, 3> Film::unfolded_points(Triangle t) const {
  const Vec3& first = position(corners(t)[0]);
  const Vec3 second = first + vector(edges(t)[0]);
  return {first, second, second + vector(edges(t)[1])};
}

void Film::move_by_periods(Vertex v, const Wrap& by) {
  positions_.edit()[v.index] += lattice_->shift(by);
  for_each_end(v, [&](EdgeEnd end) {
    const Wrap w = wrap(SignedEdge(end.edge(), false));
    set_wrap(end.edge(), end.end() == 0 ? w + by : w - by);
  });
}

void Film::gather_in_cell() {
  const Vec3 middle = lattice_->shift({{1, 1, 1}}) / 2;
  for (std::uint32_t v = 0; v < vertex_rows(); ++v) {
    if (!alive(Vertex(v))) continue;
    const Wrap away = lattice_->nearest(position(Vertex(v)) - middle);
    if (away != Wrap{}) move_by_periods(Vertex(v), -away);
  }
}

}  // namespace lamella::film
