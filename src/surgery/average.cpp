#include "surgery/average.h"

#include <algorithm>
#include <array>
#include <vector>

#include "energy/triangle.h"
#include "film/normals.h"
#include "film/vertex_place.h"

namespace lamella::surgery {

using film::ElementKind;
using film::Film;
using film::Triangle;
using film::Vec3;
using film::Vertex;

namespace {

constexpr int most_halvings = 4;
constexpr double sliver = 0.1;  // double area over the square of the longest edge

// Toward the mean of the two neighbouring segments' middles, weighted by their lengths, along the line. The
// segments lead outward.
Vec3 move_along_line(const Vec3& before, const Vec3& after) {
  const double l1 = length(before);
  const double l2 = length(after);
  if (l1 + l2 == 0) return {};
  const Vec3 wanted = (0.5 * l1 * before + 0.5 * l2 * after) / (l1 + l2);
  const Vec3 tangent = unit(after - before);
  return dot(wanted, tangent) * tangent;
}

// Sums over the facets around each vertex: area, and area times centroid (from the vertex).
struct Star {
  double area = 0;
  Vec3 moment;
};

std::vector<Star> stars(const Film& film) {
  std::vector<Star> result(film.vertex_rows());
  for (std::uint32_t t = 0; t < film.triangle_rows(); ++t) {
    const auto& c = film.corners(Triangle(t));
    if (!c[0].valid()) continue;
    const std::array<Vec3, 3> p = film.points(Triangle(t));
    const double area = energy::triangle_area(p[0], p[1], p[2]);
    const Vec3 centroid = (p[0] + p[1] + p[2]) / 3;
    for (std::size_t k = 0; k < 3; ++k) {
      result[c[k].index].area += area;
      result[c[k].index].moment += area * (centroid - p[k]);
    }
  }
  return result;
}

std::vector<Vec3> wanted_moves(const Film& film) {
  const std::vector<Star> star = stars(film);
  const std::vector<Vec3> normals = film::area_vectors(film, film.positions());
  const auto fixed = film.columns(ElementKind::vertex).flags("fixed");
  std::vector<Vec3> moves(film.vertex_rows());
  for (std::uint32_t i = 0; i < film.vertex_rows(); ++i) {
    const Vertex v(i);
    if (!film.alive(v) || star[i].area == 0 || (!fixed.empty() && fixed[i] != 0)) continue;
    const film::VertexPlace place = film::place_of(film, v);
    if (place.kind == film::PlaceKind::inside) {
      const Vec3 wanted = star[i].moment / star[i].area;
      const Vec3 n = unit(normals[i]);
      moves[i] = wanted - dot(wanted, n) * n;
    } else if (place.kind == film::PlaceKind::line) {
      moves[i] = move_along_line(film.vector(place.edges[0]), film.vector(place.edges[1]));
    }
  }
  return moves;
}

// Whether a facet survives a move: it stays, or turns by less than 60 degrees, or it was a sliver, whose
// normal means little, and gains area.
bool survives(const std::array<Vec3, 3>& from, const std::array<Vec3, 3>& to) {
  if (from == to) return true;
  const Vec3 before = energy::double_area_vector(from[0], from[1], from[2]);
  const Vec3 after = energy::double_area_vector(to[0], to[1], to[2]);
  const double longest = std::max({squared_length(from[1] - from[0]), squared_length(from[2] - from[1]),
                                   squared_length(from[0] - from[2])});
  if (length(before) < sliver * longest) return length(after) >= length(before);
  return dot(before, after) > 0.5 * length(before) * length(after);
}

// Scales down the moves of vertices whose facets would not survive. True if there were none.
bool tame(const Film& film, std::vector<Vec3>& moves, double factor) {
  std::vector<std::uint8_t> scaled(moves.size(), 0);
  bool none = true;
  for (std::uint32_t t = 0; t < film.triangle_rows(); ++t) {
    const auto& c = film.corners(Triangle(t));
    if (!c[0].valid()) continue;
    const std::array<Vec3, 3> from = film.points(Triangle(t));
    std::array<Vec3, 3> to;
    for (std::size_t k = 0; k < 3; ++k) to[k] = from[k] + moves[c[k].index];
    if (survives(from, to)) continue;
    none = false;
    for (const Vertex v : c) scaled[v.index] = 1;
  }
  for (std::size_t v = 0; v < moves.size(); ++v) {
    if (scaled[v] != 0) moves[v] = factor > 0 ? factor * moves[v] : Vec3{};
  }
  return none;
}

}  // namespace

std::uint32_t average_vertices(Film& film) {
  std::vector<Vec3> moves = wanted_moves(film);
  // Halved a few times, then stopped: each round lets fewer vertices go on, so it ends.
  for (int round = 0; !tame(film, moves, round < most_halvings ? 0.5 : 0.0); ++round) {
  }
  const std::span<Vec3> positions = film.edit_positions();
  std::uint32_t count = 0;
  for (std::size_t v = 0; v < moves.size(); ++v) {
    positions[v] += moves[v];
    count += moves[v] == Vec3{} ? 0 : 1;
  }
  return count;
}

}  // namespace lamella::surgery
