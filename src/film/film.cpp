#include "film/film.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace lamella::film {

bool Film::is_compact() const {
  return connectivity_->dead_vertices == 0 && connectivity_->dead_edges == 0 &&
         connectivity_->dead_triangles == 0;
}

// With the edge along z and the opposite corner along x, the normal of a side that runs along the edge is y:
// counterclockwise from the triangle comes what is in front of it.
Region Film::region_after(Side s) const {
  const RegionPair pair = regions(s.triangle());
  return edge_of(s).reversed() ? pair.behind : pair.front;
}

Region Film::region_before(Side s) const {
  const RegionPair pair = regions(s.triangle());
  return edge_of(s).reversed() ? pair.front : pair.behind;
}

int Film::valence(Edge e) const {
  int count = 0;
  for_each_side(e, [&](Side) { ++count; });
  return count;
}

int Film::valence(Vertex v) const {
  int count = 0;
  for_each_end(v, [&](EdgeEnd) { ++count; });
  return count;
}

SignedEdge Film::find_edge(Vertex from, Vertex to) const {
  SignedEdge found;
  for_each_end(from, [&](EdgeEnd end) {
    if (!found.valid() && head(end.outward()) == to) found = end.outward();
  });
  return found;
}

Vertex Film::add_vertex(const Vec3& position) {
  Connectivity& c = connectivity_.edit();
  const Vertex v(c.vertex_end.size());
  c.vertex_end.emplace_back();
  positions_.edit().push_back(position);
  columns_[0].resize(c.vertex_end.size());
  if (!numbers_[0]->of_row.empty()) numbers_[0].edit().append();
  return v;
}

Edge Film::add_edge(Vertex tail, Vertex head) {
  Connectivity& c = connectivity_.edit();
  const Edge e(c.edge_vertices.size());
  c.edge_vertices.push_back({tail, head});
  c.edge_side.emplace_back();
  c.next_end.emplace_back();
  insert_end(EdgeEnd(e, 0), tail);
  insert_end(EdgeEnd(e, 1), head);
  columns_[1].resize(c.edge_vertices.size());
  if (!numbers_[1]->of_row.empty()) numbers_[1].edit().append();
  return e;
}

Triangle Film::add_unlinked_triangle(const std::array<SignedEdge, 3>& edges, RegionPair regions) {
  for (std::size_t k = 0; k < 3; ++k) assert(head(edges[k]) == tail(edges[(k + 1) % 3]));
  Connectivity& c = connectivity_.edit();
  const Triangle t(c.triangle_vertices.size());
  c.triangle_vertices.push_back({tail(edges[0]), tail(edges[1]), tail(edges[2])});
  c.triangle_edges.push_back(edges);
  c.triangle_regions.push_back(regions);
  c.next_side.resize(c.next_side.size() + 3);
  columns_[2].resize(c.triangle_vertices.size());
  if (!numbers_[2]->of_row.empty()) numbers_[2].edit().append();
  return t;
}

Triangle Film::add_triangle(const std::array<SignedEdge, 3>& edges, RegionPair regions) {
  const Triangle t = add_unlinked_triangle(edges, regions);
  for (int k = 0; k < 3; ++k) insert_side(Side(t, k), edges[static_cast<std::size_t>(k)].edge());
  return t;
}

void Film::rewrite(Triangle t, const std::array<SignedEdge, 3>& edges) {
  Connectivity& c = connectivity_.edit();
  c.triangle_edges[t.index] = edges;
  for (std::size_t k = 0; k < 3; ++k) c.triangle_vertices[t.index][k] = tail(edges[k]);
}

void Film::set_ring(Edge e, std::span<const Side> sides) {
  Connectivity& c = connectivity_.edit();
  c.edge_side[e.index] = sides.empty() ? Side{} : sides[0];
  for (std::size_t i = 0; i < sides.size(); ++i) c.next_side[sides[i].index] = sides[(i + 1) % sides.size()];
}

void Film::replace_in_ring(Edge e, Side old, Side made) {
  Connectivity& c = connectivity_.edit();
  Side before = old;
  while (c.next_side[before.index] != old) before = c.next_side[before.index];
  const Side after = c.next_side[old.index];
  c.next_side[made.index] = after == old ? made : after;
  if (before != old) c.next_side[before.index] = made;
  if (c.edge_side[e.index] == old) c.edge_side[e.index] = made;
}

void Film::reattach(EdgeEnd end, Vertex to) {
  remove_end(end, at(end));
  connectivity_.edit().edge_vertices[end.edge().index][static_cast<std::size_t>(end.end())] = to;
  insert_end(end, to);
}

void Film::begin_rings_alike() {
  Connectivity& c = connectivity_.edit();
  for (EdgeEnd& first : c.vertex_end) {
    if (first != dead_vertex) first = {};
  }
  for (std::uint32_t i = 0; i < edge_rows(); ++i) {
    const Edge e(i);
    if (!alive(e)) continue;
    for (int end = 0; end < 2; ++end) insert_end(EdgeEnd(e, end), ends(e)[static_cast<std::size_t>(end)]);
    Side& first = c.edge_side[i];
    const Side start = first;
    for (Side s = start; s.valid();) {
      if (s.index < first.index) first = s;
      s = c.next_side[s.index];
      if (s == start) break;
    }
  }
}

void Film::remove(Triangle t) {
  Connectivity& c = connectivity_.edit();
  for (int k = 0; k < 3; ++k) remove_side(Side(t, k), edge_of(Side(t, k)).edge());
  c.triangle_vertices[t.index] = {};
  ++c.dead_triangles;
}

void Film::remove(Edge e) {
  assert(!first_side(e).valid());
  Connectivity& c = connectivity_.edit();
  for (int end = 0; end < 2; ++end) remove_end(EdgeEnd(e, end), ends(e)[static_cast<std::size_t>(end)]);
  c.edge_vertices[e.index] = {};
  ++c.dead_edges;
}

void Film::remove(Vertex v) {
  assert(!first_end(v).valid());
  Connectivity& c = connectivity_.edit();
  c.vertex_end[v.index] = dead_vertex;
  ++c.dead_vertices;
}

void Film::insert_end(EdgeEnd end, Vertex v) {
  Connectivity& c = connectivity_.edit();
  const auto next = [&](EdgeEnd at) -> EdgeEnd& {
    return c.next_end[at.edge().index][static_cast<std::size_t>(at.end())];
  };
  const EdgeEnd first = c.vertex_end[v.index];
  if (first.valid()) {
    next(end) = next(first);
    next(first) = end;
  } else {
    next(end) = end;
    c.vertex_end[v.index] = end;
  }
}

void Film::remove_end(EdgeEnd end, Vertex v) {
  Connectivity& c = connectivity_.edit();
  const auto next = [&](EdgeEnd at) -> EdgeEnd& {
    return c.next_end[at.edge().index][static_cast<std::size_t>(at.end())];
  };
  EdgeEnd before = end;
  while (next(before) != end) before = next(before);
  if (before == end) {
    c.vertex_end[v.index] = EdgeEnd{};
  } else {
    next(before) = next(end);
    c.vertex_end[v.index] = before;
  }
  next(end) = EdgeEnd{};
}

void Film::insert_side(Side s, Edge e) {
  Connectivity& c = connectivity_.edit();
  const Side first = c.edge_side[e.index];
  if (first.valid()) {
    c.next_side[s.index] = c.next_side[first.index];
    c.next_side[first.index] = s;
  } else {
    c.next_side[s.index] = s;
    c.edge_side[e.index] = s;
  }
}

void Film::remove_side(Side s, Edge e) {
  Connectivity& c = connectivity_.edit();
  Side before = s;
  while (c.next_side[before.index] != s) before = c.next_side[before.index];
  if (before == s) {
    c.edge_side[e.index] = Side{};
  } else {
    c.next_side[before.index] = c.next_side[s.index];
    c.edge_side[e.index] = before;
  }
  c.next_side[s.index] = Side{};
}

Vec3 apex_direction(const Film& film, Side s) {
  const auto edge_at = [&](int corner) { return film.edges(s.triangle())[static_cast<std::size_t>(corner)]; };
  return film.edge_of(s).reversed() ? film.vector(edge_at(next_corner(s.corner())))
                                    : -film.vector(edge_at(previous_corner(s.corner())));
}

void Film::sort_sides(Edge e) {
  struct Placed {
    Side side;
    double angle = 0;
  };
  std::vector<Placed> sides;
  for_each_side(e, [&](Side s) { sides.push_back({s}); });
  if (sides.size() < 3) return;

  const Vec3 axis = unit(vector(e));
  const Vec3 reference = apex_direction(*this, sides[0].side);
  const Vec3 across = reference - dot(reference, axis) * axis;
  const Vec3 up = cross(axis, across);
  for (Placed& placed : sides) {
    const Vec3 d = apex_direction(*this, placed.side);
    placed.angle = std::atan2(dot(d, up), dot(d, across));
    if (placed.angle < 0) placed.angle += 2 * M_PI;
  }
  sides[0].angle = 0;
  std::stable_sort(sides.begin() + 1, sides.end(),
                   [](const Placed& a, const Placed& b) { return a.angle < b.angle; });
  Connectivity& c = connectivity_.edit();
  for (std::size_t i = 0; i < sides.size(); ++i) {
    c.next_side[sides[i].side.index] = sides[(i + 1) % sides.size()].side;
  }
}

void Film::sort_all_sides() {
  for (std::uint32_t e = 0; e < edge_rows(); ++e) {
    const Side first = first_side(Edge(e));
    if (!first.valid() || next_around(next_around(first)) == first) continue;  // wire, rim or inside a film
    sort_sides(Edge(e));
  }
}

void Film::reserve(std::size_t vertices, std::size_t edges, std::size_t triangles) {
  Connectivity& c = connectivity_.edit();
  c.triangle_vertices.reserve(triangles);
  c.triangle_edges.reserve(triangles);
  c.triangle_regions.reserve(triangles);
  c.next_side.reserve(3 * triangles);
  c.edge_vertices.reserve(edges);
  c.edge_side.reserve(edges);
  c.next_end.reserve(edges);
  c.vertex_end.reserve(vertices);
  positions_.edit().reserve(vertices);
}

void Film::columns_follow_rows() {
  columns_[0].resize(vertex_rows());
  columns_[1].resize(edge_rows());
  columns_[2].resize(triangle_rows());
}

void Film::take_complex(Film&& other) {
  connectivity_ = std::move(other.connectivity_);
  positions_ = std::move(other.positions_);
  restart_numbers();
  columns_follow_rows();
}

void Film::inherit(Vertex made, Edge split) {
  inherit(made, ends(split)[0], ends(split)[1], split);
}

void Film::inherit(Vertex made, Vertex a, Vertex b, Edge split) {
  columns_[0].edit_each([&](Column& column) {
    if (column.inheritance.on_new == Inheritance::New::mean) {
      column.set_mean(a.index, b.index, made.index);
    } else if (column.inheritance.on_new == Inheritance::New::parent) {
      if (const Column* source = columns_[1].find(column.name)) {
        column.copy_row_of(*source, split.index, made.index);
      }
    }
  });
}

void Film::inherit(Vertex made, Triangle inside) {
  const std::array<Vertex, 3>& corner = corners(inside);
  columns_[0].edit_each([&](Column& column) {
    if (column.inheritance.on_new == Inheritance::New::mean) {
      for (int k = 0; k < column.width; ++k) {
        double sum = 0;
        for (const Vertex v : corner) sum += column.value(v.index, k);
        column.set(made.index, k, sum / 3);
      }
    } else if (column.inheritance.on_new == Inheritance::New::parent) {
      if (const Column* source = columns_[2].find(column.name)) {
        column.copy_row_of(*source, inside.index, made.index);
      }
    }
  });
}

void Film::inherit(Edge half, Edge split) {
  columns_[1].edit_each([&](Column& column) { column.copy_row(split.index, half.index); });
}

void Film::inherit(Edge made, Triangle inside) {
  columns_[1].edit_each([&](Column& column) {
    if (column.inheritance.on_new != Inheritance::New::parent) return;
    if (const Column* source = columns_[2].find(column.name)) {
      column.copy_row_of(*source, inside.index, made.index);
    }
  });
}

void Film::inherit(Triangle part, Triangle whole) {
  columns_[2].edit_each([&](Column& column) { column.copy_row(whole.index, part.index); });
}

// Numbers mostly stand in ascending order of rows; where they do not, every row is looked at.
std::uint32_t Film::Numbers::row(std::uint32_t number, std::uint32_t rows) const {
  if (of_row.empty()) return number >= 1 && number <= rows ? number - 1 : no_index;
  const auto sorted = std::lower_bound(of_row.begin(), of_row.end(), number);
  if (sorted != of_row.end() && *sorted == number) return static_cast<std::uint32_t>(sorted - of_row.begin());
  const auto found = std::find(of_row.begin(), of_row.end(), number);
  return found != of_row.end() ? static_cast<std::uint32_t>(found - of_row.begin()) : no_index;
}

Vertex Film::vertex_numbered(std::uint32_t number) const {
  const Vertex v(numbers_[0]->row(number, vertex_rows()));
  return v.valid() && alive(v) ? v : Vertex{};
}

Edge Film::edge_numbered(std::uint32_t number) const {
  const Edge e(numbers_[1]->row(number, edge_rows()));
  return e.valid() && alive(e) ? e : Edge{};
}

Triangle Film::triangle_numbered(std::uint32_t number) const {
  const Triangle t(numbers_[2]->row(number, triangle_rows()));
  return t.valid() && alive(t) ? t : Triangle{};
}

void Film::restart_numbers() {
  for (Shared<Numbers>& numbers : numbers_) {
    if (!numbers->of_row.empty()) numbers.edit() = {};
  }
}

void Film::set_numbers(ElementKind kind, std::vector<std::uint32_t> numbers) {
  Numbers set;
  bool plain = true;
  for (std::size_t row = 0; row < numbers.size(); ++row) {
    set.last = std::max(set.last, numbers[row]);
    plain = plain && numbers[row] == row + 1;
  }
  set.of_row = std::move(numbers);
  numbers_[static_cast<std::size_t>(kind)].edit() = plain ? Numbers{} : std::move(set);
}

View Film::view() const {
  assert(is_compact());
  return {*positions_, connectivity_->triangle_vertices, connectivity_->triangle_regions,
          connectivity_->edge_vertices, connectivity_.revision()};
}

std::size_t Film::bytes() const {
  const Connectivity& c = *connectivity_;
  const auto size = [](const auto& v) { return v.size() * sizeof(v[0]); };
  std::size_t total = 0;
  for (const Shared<Numbers>& numbers : numbers_) total += size(numbers->of_row);
  return total + size(c.triangle_vertices) + size(c.triangle_edges) + size(c.triangle_regions) +
         size(c.next_side) + size(c.edge_vertices) + size(c.edge_side) + size(c.next_end) +
         size(c.vertex_end) + size(*positions_);
}

std::size_t Film::bytes_with_columns() const {
  std::size_t total = bytes();
  for (const Columns& columns : columns_) total += columns.bytes();
  return total;
}

}  // namespace lamella::film
