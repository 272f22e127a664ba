#include "surgery/average.h"

#include <vector>

#include "energy/triangle.h"

namespace lamella::surgery {

using film::Edge;
using film::EdgeEnd;
using film::ElementKind;
using film::Film;
using film::Triangle;
using film::Vec3;
using film::Vertex;

namespace {

constexpr int most_halvings = 6;

// What a vertex's edges say about where it lies: all inside one film, or on a line of borders or rims between
// two neighbours.
struct Place {
  bool inside_film = true;
  int line_edges = 0;
  std::array<Vertex, 2> neighbours;
};

Place place_of(const Film& film, Vertex v) {
  Place place;
  film.for_each_end(v, [&](EdgeEnd end) {
    if (film.valence(end.edge()) == 2) return;
    place.inside_film = false;
    if (place.line_edges < 2)
      place.neighbours[static_cast<std::size_t>(place.line_edges)] = film.head(end.outward());
    ++place.line_edges;
  });
  return place;
}

// Toward the mean of the two neighbouring segments' middles, weighted by their lengths, along the line.
Vec3 move_along_line(const Vec3& at, const Vec3& before, const Vec3& after) {
  const double l1 = length(before - at);
  const double l2 = length(after - at);
  if (l1 + l2 == 0) return {};
  const Vec3 wanted = (0.5 * l1 * (before - at) + 0.5 * l2 * (after - at)) / (l1 + l2);
  const Vec3 tangent = unit(after - before);
  return dot(wanted, tangent) * tangent;
}

// Sums over the facets around each vertex: area, area times centroid (from the vertex), oriented area.
struct Star {
  double area = 0;
  Vec3 moment;
  Vec3 normal;
};

std::vector<Star> stars(const Film& film) {
  std::vector<Star> result(film.vertex_rows());
  for (std::uint32_t i = 0; i < film.triangle_rows(); ++i) {
    const Triangle t(i);
    if (!film.alive(t)) continue;
    const auto& c = film.corners(t);
    const Vec3& p0 = film.position(c[0]);
    const Vec3& p1 = film.position(c[1]);
    const Vec3& p2 = film.position(c[2]);
    const Vec3 normal = 0.5 * energy::double_area_vector(p0, p1, p2);
    const double area = length(normal);
    const Vec3 centroid = (p0 + p1 + p2) / 3;
    for (const Vertex v : c) {
      Star& star = result[v.index];
      star.area += area;
      star.moment += area * (centroid - film.position(v));
      // Facets of one film may be listed with either orientation.
      star.normal += dot(star.normal, normal) < 0 ? -normal : normal;
    }
  }
  return result;
}

std::vector<Vec3> wanted_moves(const Film& film) {
  const std::vector<Star> star = stars(film);
  const auto fixed = film.columns(ElementKind::vertex).flags("fixed");
  std::vector<Vec3> moves(film.vertex_rows());
  for (std::uint32_t i = 0; i < film.vertex_rows(); ++i) {
    const Vertex v(i);
    if (!film.alive(v) || star[i].area == 0 || (!fixed.empty() && fixed[i] != 0)) continue;
    const Place place = place_of(film, v);
    if (place.inside_film) {
      const Vec3 wanted = star[i].moment / star[i].area;
      const Vec3 n = unit(star[i].normal);
      moves[i] = wanted - dot(wanted, n) * n;
    } else if (place.line_edges == 2) {
      moves[i] = move_along_line(film.position(v), film.position(place.neighbours[0]),
                                 film.position(place.neighbours[1]));
    }
  }
  return moves;
}

// Halves the moves of vertices whose facets would turn by more than 60 degrees. True if there were none.
bool tame(const Film& film, std::vector<Vec3>& moves) {
  std::vector<std::uint8_t> halved(moves.size(), 0);
  bool none = true;
  for (std::uint32_t i = 0; i < film.triangle_rows(); ++i) {
    const Triangle t(i);
    if (!film.alive(t)) continue;
    const auto& c = film.corners(t);
    const auto moved = [&](std::size_t k) { return film.position(c[k]) + moves[c[k].index]; };
    const Vec3 before =
        energy::double_area_vector(film.position(c[0]), film.position(c[1]), film.position(c[2]));
    const Vec3 after = energy::double_area_vector(moved(0), moved(1), moved(2));
    if (dot(before, after) > 0.5 * length(before) * length(after) || length(before) == 0) continue;
    none = false;
    for (const Vertex v : c) halved[v.index] = 1;
  }
  for (std::size_t v = 0; v < moves.size(); ++v) {
    if (halved[v] != 0) moves[v] *= 0.5;
  }
  return none;
}

}  // namespace

std::uint32_t average_vertices(Film& film) {
  std::vector<Vec3> moves = wanted_moves(film);
  bool tamed = tame(film, moves);
  for (int i = 0; i < most_halvings && !tamed; ++i) tamed = tame(film, moves);
  if (!tamed) return 0;
  const std::span<Vec3> positions = film.edit_positions();
  std::uint32_t count = 0;
  for (std::size_t v = 0; v < moves.size(); ++v) {
    positions[v] += moves[v];
    count += moves[v] == Vec3{} ? 0 : 1;
  }
  return count;
}

}  // namespace lamella::surgery
