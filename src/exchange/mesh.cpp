#include "exchange/mesh.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>

#include "picture/lines.h"

namespace lamella::exchange {

using film::Edge;
using film::ElementKind;
using film::Film;
using film::Triangle;
using film::Vec3;
using film::Vertex;
using picture::LineKind;

namespace {

// The points of a mesh: one for each vertex, and one more for each place beyond a period at which a triangle
// or a line needs it.
class Points {
 public:
  explicit Points(const Film& film) : film_(film), own_(film.vertex_rows(), film::no_index) {
    for (std::uint32_t v = 0; v < film.vertex_rows(); ++v) {
      if (!film.alive(Vertex(v))) continue;
      own_[v] = add(Vertex(v), film.position(Vertex(v)));
      const Vec3 p = film.position(Vertex(v));
      size_ = std::max({size_, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    }
  }

  std::uint32_t of(Vertex v, const Vec3& place) {
    const Vec3 offset = place - film_.position(v);
    if (length(offset) <= same * size_) return own_[v.index];
    const auto step = [&](double x) { return std::lround(x / (64 * same * size_)); };
    const auto [at, made] =
        beyond_.try_emplace({v.index, step(offset.x), step(offset.y), step(offset.z)}, 0U);
    if (made) at->second = add(v, place);
    return at->second;
  }

  std::vector<Vec3> places;
  std::vector<Vertex> vertices;  // one a place

 private:
  static constexpr double same = 1e-9;

  std::uint32_t add(Vertex v, const Vec3& place) {
    places.push_back(place);
    vertices.push_back(v);
    return static_cast<std::uint32_t>(places.size() - 1);
  }

  const Film& film_;
  std::vector<std::uint32_t> own_;
  std::map<std::array<long, 4>, std::uint32_t> beyond_;
  double size_ = 0;
};

std::string plain_name(std::string_view name) {
  std::string result;
  for (const char c : name) result += std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
  return result;
}

// A column's values for these rows.
template <class Rows, class Row>
Attribute attribute(const film::Column& column, const Rows& rows, Row&& row_of) {
  Attribute result{
      plain_name(column.name), column.width, !std::holds_alternative<film::Reals>(column.data), {}};
  result.values.reserve(rows.size() * static_cast<std::size_t>(column.width));
  for (const auto& element : rows) {
    for (int k = 0; k < column.width; ++k) result.values.push_back(column.value(row_of(element), k));
  }
  return result;
}

template <class Rows, class Row, class Number>
std::vector<Attribute> attributes(const film::Columns& columns, const Rows& rows, Row&& row_of,
                                  Number&& number_of) {
  std::vector<Attribute> result;
  Attribute id{"id", 1, true, {}};
  for (const auto& element : rows) id.values.push_back(number_of(element));
  result.push_back(std::move(id));
  columns.for_each([&](const film::Column& column) {
    if (column.width > 0) result.push_back(attribute(column, rows, row_of));
  });
  return result;
}

// Joins edges to lines: each goes on through points where exactly two edges of its kind meet.
class LineJoiner {
 public:
  LineJoiner(LineKind kind, std::vector<std::array<std::uint32_t, 2>> edges)
      : kind_(kind), edges_(std::move(edges)), used_(edges_.size(), false) {
    for (std::uint32_t i = 0; i < edges_.size(); ++i) {
      for (const std::uint32_t p : edges_[i]) at_[p].push_back(i);
    }
  }

  void join(std::vector<Line>& lines) {
    for (std::uint32_t i = 0; i < edges_.size(); ++i) {
      for (const std::uint32_t p : edges_[i]) {
        if (!used_[i] && at_[p].size() != 2) lines.push_back(walk(i, p));
      }
    }
    for (std::uint32_t i = 0; i < edges_.size(); ++i) {
      if (!used_[i]) lines.push_back(walk(i, edges_[i][0]));
    }
  }

 private:
  Line walk(std::uint32_t edge, std::uint32_t from) {
    Line line{kind_, {from}};
    while (true) {
      used_[edge] = true;
      const std::uint32_t to = edges_[edge][0] == line.points.back() ? edges_[edge][1] : edges_[edge][0];
      line.points.push_back(to);
      const std::vector<std::uint32_t>& next = at_[to];
      if (next.size() != 2) return line;
      edge = next[0] == edge ? next[1] : next[0];
      if (used_[edge]) return line;
    }
  }

  LineKind kind_;
  std::vector<std::array<std::uint32_t, 2>> edges_;
  std::vector<bool> used_;
  std::map<std::uint32_t, std::vector<std::uint32_t>> at_;
};

std::vector<Line> lines_of(const Film& film, Points& points) {
  std::map<LineKind, std::vector<std::array<std::uint32_t, 2>>> edges;
  for (std::uint32_t i = 0; i < film.edge_rows(); ++i) {
    const Edge e(i);
    if (!film.alive(e)) continue;
    const LineKind kind = picture::line_kind(film, e);
    if (kind == LineKind::none) continue;
    const auto& [tail, head] = film.ends(e);
    const Vec3 from = film.position(tail);
    edges[kind].push_back(
        {points.of(tail, from), points.of(head, from + film.vector(film::SignedEdge(e, false)))});
  }
  std::vector<Line> lines;
  for (auto& [kind, list] : edges) LineJoiner(kind, std::move(list)).join(lines);
  return lines;
}

}  // namespace

std::string_view name_of(LineKind kind) {
  switch (kind) {
    case LineKind::border:
      return "border";
    case LineKind::rim:
      return "rim";
    case LineKind::wire:
      return "wire";
    default:
      return "line";
  }
}

Mesh mesh_of(const scene::Scene& scene) {
  const Film& film = scene.film;
  Mesh mesh;
  Points points(film);
  std::vector<Triangle> rows;
  for (std::uint32_t i = 0; i < film.triangle_rows(); ++i) {
    const Triangle t(i);
    if (!film.alive(t)) continue;
    const std::array<Vec3, 3> places = film.points(t);
    Triple corners{};
    for (std::size_t k = 0; k < 3; ++k) corners[k] = points.of(film.corners(t)[k], places[k]);
    mesh.triangles.push_back(corners);
    mesh.regions.push_back(film.regions(t));
    rows.push_back(t);
  }
  mesh.lines = lines_of(film, points);
  const auto row = [](auto element) { return element.index; };
  const auto number = [&](auto element) { return static_cast<double>(film.number(element)); };
  mesh.of_points = attributes(film.columns(ElementKind::vertex), points.vertices, row, number);
  mesh.of_triangles = attributes(film.columns(ElementKind::facet), rows, row, number);
  mesh.points = std::move(points.places);
  return mesh;
}

}  // namespace lamella::exchange
