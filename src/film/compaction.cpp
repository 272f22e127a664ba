// Film::compact and Film::renumber: moving rows while ids inside the arrays, columns and numbers follow.
#include <algorithm>

#include "film/film.h"

namespace lamella::film {

namespace {

using Order = std::span<const std::uint32_t>;

std::vector<std::uint32_t> inverse(Order old_of_new, std::size_t old_rows) {
  std::vector<std::uint32_t> new_of_old(old_rows, no_index);
  for (std::size_t i = 0; i < old_of_new.size(); ++i)
    new_of_old[old_of_new[i]] = static_cast<std::uint32_t>(i);
  return new_of_old;
}

template <class T>
std::vector<T> picked(const std::vector<T>& rows, Order old_of_new) {
  std::vector<T> result;
  result.reserve(old_of_new.size());
  for (const std::uint32_t old : old_of_new) result.push_back(rows[old]);
  return result;
}

std::vector<std::uint32_t> live_rows(std::uint32_t rows, auto&& alive) {
  std::vector<std::uint32_t> result;
  result.reserve(rows);
  for (std::uint32_t i = 0; i < rows; ++i) {
    if (alive(i)) result.push_back(i);
  }
  return result;
}

}  // namespace

// The numbers stay without rows while they would still be row + 1.
Film::Numbers Film::Numbers::renumbered(Order old_of_new) const {
  Numbers result;
  result.of_row.reserve(old_of_new.size());
  result.last = last;
  bool plain = true;
  for (const std::uint32_t old : old_of_new) {
    result.of_row.push_back((*this)[old]);
    result.last = std::max(result.last, result.of_row.back());
    plain = plain && result.of_row.back() == result.of_row.size();
  }
  if (plain) result = {};
  return result;
}

void Film::compact() {
  if (is_compact()) return;
  renumber(live_rows(vertex_rows(), [&](std::uint32_t i) { return alive(Vertex(i)); }),
           live_rows(edge_rows(), [&](std::uint32_t i) { return alive(Edge(i)); }),
           live_rows(triangle_rows(), [&](std::uint32_t i) { return alive(Triangle(i)); }));
}

void Film::renumber(Order vertices, Order edges, Order triangles) {
  const Connectivity& old = *connectivity_;
  const std::vector<std::uint32_t> new_vertex = inverse(vertices, old.vertex_end.size());
  const std::vector<std::uint32_t> new_edge = inverse(edges, old.edge_vertices.size());
  const std::vector<std::uint32_t> new_triangle = inverse(triangles, old.triangle_vertices.size());
  const auto moved_end = [&](EdgeEnd end) {
    return end.valid() ? EdgeEnd(Edge(new_edge[end.edge().index]), end.end()) : end;
  };
  const auto moved_side = [&](Side s) {
    return s.valid() ? Side(Triangle(new_triangle[s.triangle().index]), s.corner()) : s;
  };

  Connectivity c;
  c.triangle_vertices = picked(old.triangle_vertices, triangles);
  c.triangle_edges = picked(old.triangle_edges, triangles);
  c.triangle_regions = picked(old.triangle_regions, triangles);
  for (auto& corner : c.triangle_vertices) {
    for (Vertex& v : corner) v = Vertex(new_vertex[v.index]);
  }
  for (auto& side : c.triangle_edges) {
    for (SignedEdge& e : side) e = SignedEdge(Edge(new_edge[e.edge().index]), e.reversed());
  }
  c.next_side.reserve(3 * triangles.size());
  for (const std::uint32_t t : triangles) {
    for (std::size_t k = 0; k < 3; ++k)
      c.next_side.push_back(moved_side(old.next_side[3 * std::size_t{t} + k]));
  }
  c.edge_vertices = picked(old.edge_vertices, edges);
  c.edge_side = picked(old.edge_side, edges);
  c.next_end = picked(old.next_end, edges);
  for (auto& ends : c.edge_vertices) {
    for (Vertex& v : ends) v = Vertex(new_vertex[v.index]);
  }
  for (Side& s : c.edge_side) s = moved_side(s);
  for (auto& next : c.next_end) {
    for (EdgeEnd& end : next) end = moved_end(end);
  }
  c.vertex_end = picked(old.vertex_end, vertices);
  for (EdgeEnd& end : c.vertex_end) end = moved_end(end);

  positions_.edit() = picked(*positions_, vertices);
  connectivity_.edit() = std::move(c);
  const std::array<Order, 3> orders{vertices, edges, triangles};
  for (std::size_t kind = 0; kind < 3; ++kind) {
    columns_[kind].edit_each([&](Column& column) { column.renumber(orders[kind]); });
    columns_[kind].resize(orders[kind].size());
    numbers_[kind].edit() = numbers_[kind]->renumbered(orders[kind]);
  }
}

}  // namespace lamella::film
