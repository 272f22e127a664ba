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

// Array by array, so that no more than one of them is there twice.
template <class T>
void pick(std::vector<T>& rows, Order old_of_new) {
  std::vector<T> result;
  result.reserve(old_of_new.size());
  for (const std::uint32_t old : old_of_new) result.push_back(rows[old]);
  rows = std::move(result);
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
  Connectivity& c = connectivity_.edit();
  const std::vector<std::uint32_t> new_vertex = inverse(vertices, c.vertex_end.size());
  const std::vector<std::uint32_t> new_edge = inverse(edges, c.edge_vertices.size());
  const std::vector<std::uint32_t> new_triangle = inverse(triangles, c.triangle_vertices.size());
  const auto move_end = [&](EdgeEnd& end) {
    if (end.valid()) end = EdgeEnd(Edge(new_edge[end.edge().index]), end.end());
  };
  const auto move_side = [&](Side& s) {
    if (s.valid()) s = Side(Triangle(new_triangle[s.triangle().index]), s.corner());
  };

  pick(c.triangle_vertices, triangles);
  pick(c.triangle_edges, triangles);
  pick(c.triangle_regions, triangles);
  for (auto& corner : c.triangle_vertices) {
    for (Vertex& v : corner) v = Vertex(new_vertex[v.index]);
  }
  for (auto& side : c.triangle_edges) {
    for (SignedEdge& e : side) e = SignedEdge(Edge(new_edge[e.edge().index]), e.reversed());
  }
  std::vector<Side> next_side;
  next_side.reserve(3 * triangles.size());
  for (const std::uint32_t t : triangles) {
    for (std::size_t k = 0; k < 3; ++k) next_side.push_back(c.next_side[3 * std::size_t{t} + k]);
  }
  c.next_side = std::move(next_side);
  for (Side& s : c.next_side) move_side(s);
  pick(c.edge_vertices, edges);
  pick(c.edge_side, edges);
  pick(c.next_end, edges);
  for (auto& ends : c.edge_vertices) {
    for (Vertex& v : ends) v = Vertex(new_vertex[v.index]);
  }
  for (Side& s : c.edge_side) move_side(s);
  for (auto& next : c.next_end) {
    for (EdgeEnd& end : next) move_end(end);
  }
  pick(c.vertex_end, vertices);
  for (EdgeEnd& end : c.vertex_end) move_end(end);
  c.dead_vertices = c.dead_edges = c.dead_triangles = 0;

  pick(positions_.edit(), vertices);
  const std::array<Order, 3> orders{vertices, edges, triangles};
  for (std::size_t kind = 0; kind < 3; ++kind) {
    columns_[kind].edit_each([&](Column& column) { column.renumber(orders[kind]); });
    columns_[kind].resize(orders[kind].size());
    numbers_[kind].edit() = numbers_[kind]->renumbered(orders[kind]);
  }
}

}  // namespace lamella::film
