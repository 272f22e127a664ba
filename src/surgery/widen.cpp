#include "surgery/widen.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "energy/mesh_quality.h"
#include "film/vertex_place.h"

namespace lamella::surgery {

using film::ElementKind;
using film::Film;
using film::Triangle;
using film::Vec3;
using film::Vertex;

namespace {

constexpr int most_passes = 30;
constexpr int directions = 8;
// Steps tried, in units of the shortest edge around; each pass halves them so many times.
constexpr double first_step = 0.4;
constexpr int halvings = 4;
// A move must gain so much of the cotangent of the smallest angle, or it is not worth the film's shape.
constexpr double worth_it = 1e-3;
// The cosine of the angle by which a facet may turn.
constexpr double flat = 0.5;

// The facets around one vertex: their other corners, seen from where the vertex was, and unit normals.
class Star {
 public:
  Star(const Film& film, Vertex v) {
    film.for_each_end(v, [&](film::EdgeEnd end) {
      const Vec3 way = film.vector(end.outward());
      shortest_ = std::min(shortest_, length(way));
      film.for_each_side(end.edge(), [&](film::Side s) {
        if (film.tail(film.edge_of(s)) != v) return;
        const std::array<Vec3, 3> p = film.points(s.triangle());
        const auto k = static_cast<std::size_t>(s.corner());
        const Vec3 b = p[(k + 1) % 3] - p[k];
        const Vec3 c = p[(k + 2) % 3] - p[k];
        facets_.push_back({b, c, unit(cross(b, c))});
        normal_ += dot(normal_, cross(b, c)) < 0 ? -cross(b, c) : cross(b, c);
      });
    });
  }
  double shortest() const { return shortest_; }
  Vec3 normal() const { return unit(normal_); }
  // The sharpest angle with the vertex moved; infinite where a facet turns too far.
  double sharpest(const Vec3& move) const {
    double worst = 0;
    for (const Facet& f : facets_) {
      const Vec3 area = cross(f.b - move, f.c - move);
      if (!(dot(area, f.normal) >= flat * length(area))) return HUGE_VAL;
      worst = std::max(worst, energy::largest_cotangent(move, f.b, f.c));
    }
    return worst;
  }

 private:
  struct Facet {
    Vec3 b;
    Vec3 c;
    Vec3 normal;
  };
  std::vector<Facet> facets_;
  Vec3 normal_;
  double shortest_ = HUGE_VAL;
};

// The unit vectors along which a vertex may go; none where it stays.
std::vector<Vec3> ways(const Film& film, Vertex v, const Star& star) {
  const film::VertexPlace place = film::place_of(film, v);
  if (place.kind == film::PlaceKind::corner) return {};
  if (place.kind == film::PlaceKind::line) {
    const Vec3 along = unit(film.vector(place.edges[1]) - film.vector(place.edges[0]));
    return {along, -along};
  }
  const Vec3 n = star.normal();
  const Vec3 other = std::abs(n.x) < 0.6 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
  const Vec3 e1 = unit(cross(n, other));
  const Vec3 e2 = cross(n, e1);
  std::vector<Vec3> result;
  for (int i = 0; i < directions; ++i)
    result.push_back(std::cos(2 * M_PI * i / directions) * e1 + std::sin(2 * M_PI * i / directions) * e2);
  return result;
}

// The best move found by steps that shorten; zero where none helps.
Vec3 best_move(const Film& film, Vertex v) {
  const Star star(film, v);
  const std::vector<Vec3> around = ways(film, v, star);
  Vec3 best;
  double least = star.sharpest(best);
  double step = first_step * star.shortest();
  for (int halving = 0; halving < halvings && !around.empty(); ++halving, step /= 2) {
    const Vec3 from = best;
    for (const Vec3& way : around) {
      const Vec3 tried = from + step * way;
      const double sharp = star.sharpest(tried);
      if (!(sharp < least - worth_it)) continue;
      least = sharp;
      best = tried;
    }
  }
  return best;
}

// The corners of facets with an angle below the wanted one.
std::vector<Vertex> near_small_angles(const Film& film, double limit) {
  std::vector<Vertex> result;
  for (std::uint32_t t = 0; t < film.triangle_rows(); ++t) {
    const auto& corners = film.corners(Triangle(t));
    if (!corners[0].valid()) continue;
    const std::array<Vec3, 3> p = film.points(Triangle(t));
    if (energy::largest_cotangent(p[0], p[1], p[2]) > limit)
      result.insert(result.end(), corners.begin(), corners.end());
  }
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

}  // namespace

std::uint32_t widen_angles(Film& film, double wanted) {
  const auto fixed = film.columns(ElementKind::vertex).flags("fixed");
  const auto held = [&](Vertex v) { return !fixed.empty() && fixed[v.index] != 0; };
  std::uint32_t moves = 0;
  for (int pass = 0; pass < most_passes; ++pass) {
    const std::uint32_t before = moves;
    for (const Vertex v : near_small_angles(film, 1 / std::tan(wanted))) {
      if (held(v)) continue;
      const Vec3 move = best_move(film, v);
      if (move == Vec3{}) continue;
      film.edit_positions()[v.index] += move;
      ++moves;
    }
    if (moves == before) break;
  }
  return moves;
}

}  // namespace lamella::surgery
