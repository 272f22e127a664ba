#include "energy/vertex_star.h"

#include <algorithm>

#include "energy/triangle_hessian.h"

namespace lamella::energy {

namespace {

using film::Film;
using film::Side;
using film::Triangle;
using film::Vertex;

struct Turned {
  Triangle triangle;
  bool reversed = false;
};

int corner_of(const Film& film, Triangle t, Vertex v) {
  const auto& corners = film.corners(t);
  return corners[0] == v ? 0 : corners[1] == v ? 1 : 2;
}

// Goes from triangle to triangle over edges with two sides, keeping the orientation.
std::vector<Turned> oriented_triangles(const Film& film, Vertex v) {
  std::vector<Turned> found;
  film.for_each_end(v, [&](film::EdgeEnd end) {
    film.for_each_side(end.edge(), [&](Side s) {
      const bool known = std::any_of(found.begin(), found.end(),
                                     [&](const Turned& t) { return t.triangle == s.triangle(); });
      if (!known) found.push_back({s.triangle(), false});
    });
  });
  std::sort(found.begin(), found.end(),
            [](const Turned& a, const Turned& b) { return a.triangle.index < b.triangle.index; });
  // Sets the orientation of neighbours from the first on.
  std::vector<std::uint8_t> done(found.size());
  std::vector<std::size_t> waiting;
  for (std::size_t start = 0; start < found.size(); ++start) {
    if (done[start] != 0) continue;
    done[start] = 1;
    waiting.push_back(start);
    while (!waiting.empty()) {
      const std::size_t at = waiting.back();
      waiting.pop_back();
      for (int k = 0; k < 3; ++k) {
        const Side side(found[at].triangle, k);
        const film::Edge edge = film.edge_of(side).edge();
        if (film.valence(edge) != 2) continue;
        const Side other = film.next_around(side);
        const auto next = std::find_if(found.begin(), found.end(),
                                       [&](const Turned& t) { return t.triangle == other.triangle(); });
        if (next == found.end()) continue;
        const auto row = static_cast<std::size_t>(next - found.begin());
        if (done[row] != 0) continue;
        done[row] = 1;
        const bool opposite_ways = film.edge_of(side).reversed() != film.edge_of(other).reversed();
        next->reversed = opposite_ways ? found[at].reversed : !found[at].reversed;
        waiting.push_back(row);
      }
    }
  }
  return found;
}

struct Sums {
  double area = 0;
  Vec3 force;   // gradient of the area
  Vec3 normal;  // gradient of the volume
};

Sums sums_of(const VertexStar& star, std::span<const Vec3> x) {
  Sums sums;
  for (const auto& [first, second, third] : star.triangles) {
    const Vec3& a = x[first];
    const Vec3& b = x[second];
    const Vec3& c = x[third];
    sums.area += triangle_area(a, b, c);
    sums.force += triangle_area_gradient(a, b, c)[0];
    sums.normal += double_area_vector(a, b, c) / 6;
  }
  for (const Vec3& mirror : star.mirrors) {
    sums.force -= dot(sums.force, mirror) * mirror;
    sums.normal -= dot(sums.normal, mirror) * mirror;
  }
  return sums;
}

// The derivatives of a function of area, force and normal, from those by these three.
StarValue chain(const VertexStar& star, std::span<const Vec3> x, double value, double by_area, Vec3 by_force,
                Vec3 by_normal) {
  for (const Vec3& mirror : star.mirrors) {
    by_force -= dot(by_force, mirror) * mirror;
    by_normal -= dot(by_normal, mirror) * mirror;
  }
  StarValue result;
  result.value = value;
  for (const auto& [first, second, third] : star.triangles) {
    const Vec3& a = x[first];
    const Vec3& b = x[second];
    const Vec3& c = x[third];
    const std::array<Vec3, 3> g = triangle_area_gradient(a, b, c);
    const TriangleHessian h = triangle_area_hessian(a, b, c);
    // The vector area turns by e x v / 2 when a corner with the opposite edge e moves by v, and the normal is
    // a third of it.
    const auto part = [&](std::size_t i, const Vec3& opposite) {
      return by_area * g[i] + transposed(h[0][i]) * by_force + cross(by_normal, opposite) / 6;
    };
    result.at_vertex += part(0, c - b);
    result.at_others.push_back({part(1, a - c), part(2, b - a)});
  }
  return result;
}

}  // namespace

VertexStar star_of(const Film& film, const film::Unfolding& unfolding, Vertex v) {
  VertexStar star;
  star.vertex = v.index;
  for (const Turned& turned : oriented_triangles(film, v)) {
    const auto& corners =
        unfolding.empty() ? film.corners(turned.triangle) : unfolding.triangles()[turned.triangle.index];
    const int k = corner_of(film, turned.triangle, v);
    const std::uint32_t own = corners[static_cast<std::size_t>(k)].index;
    const std::uint32_t next = corners[static_cast<std::size_t>((k + 1) % 3)].index;
    const std::uint32_t last = corners[static_cast<std::size_t>((k + 2) % 3)].index;
    star.triangles.push_back(turned.reversed ? std::array{own, last, next} : std::array{own, next, last});
  }
  return star;
}

std::vector<std::uint32_t> rows_of(const VertexStar& star) {
  std::vector<std::uint32_t> rows{star.vertex};
  for (const auto& corners : star.triangles) {
    for (const std::size_t k : {std::size_t{1}, std::size_t{2}}) {
      if (std::find(rows.begin(), rows.end(), corners[k]) == rows.end()) rows.push_back(corners[k]);
    }
  }
  return rows;
}

StarValue squared_curvature(const VertexStar& star, std::span<const Vec3> positions) {
  const Sums s = sums_of(star, positions);
  if (!(s.area > 0)) return chain(star, positions, 0, 0, {}, {});
  const double value = 0.75 * squared_length(s.force) / s.area;
  return chain(star, positions, value, -value / s.area, (1.5 / s.area) * s.force, {});
}

StarValue perpendicular_squared_curvature(const VertexStar& star, std::span<const Vec3> positions) {
  const Sums s = sums_of(star, positions);
  const double square = squared_length(s.normal);
  if (!(square > 0)) return chain(star, positions, 0, 0, {}, {});
  // Twice the mean curvature, for both sums belong to a third of the star's area.
  const double ratio = dot(s.force, s.normal) / square;
  const double value = s.area * ratio * ratio / 12;
  const double by_ratio = s.area * ratio / 6;
  return chain(star, positions, value, ratio * ratio / 12, (by_ratio / square) * s.normal,
               (by_ratio / square) * (s.force - (2 * ratio) * s.normal));
}

}  // namespace lamella::energy
