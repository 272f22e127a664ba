#include "surgery/proximity.h"

#include <algorithm>
#include <cmath>

#include "surgery/sizing.h"

namespace lamella::surgery {

using film::EdgeEnd;
using film::Film;
using film::Triangle;
using film::Vec3;
using film::Vertex;

namespace {

// A pair counts where the way between them leaves both sheets at more than 30 degrees: what lies beside a
// vertex in its own sheet does not.
constexpr double least_facing = 0.5;

constexpr double least_cosine = 0.085;  // of 85 degrees

Vec3 normal(const Corners& p) {
  return cross(p[1] - p[0], p[2] - p[0]);
}

bool faces(const Corners& triangle, const Vec3& way) {
  const Vec3 n = normal(triangle);
  return std::abs(dot(n, way)) >= least_facing * length(n) * length(way);
}

// Whether two facets lie in one sheet between two regions, their normals within 85 degrees: between those
// there is another sheet. Of such pairs it is left to chance which are told of.
bool are_one_sheet(const Film& film, const FacetPair& pair) {
  const film::RegionPair a = film.regions(pair.a);
  const film::RegionPair b = film.regions(pair.b);
  const bool flipped = a == b.flipped();
  if (a.front == a.behind || !(a == b || flipped)) return false;
  const Vec3 m = normal(film.points(pair.a));
  const Vec3 n = normal(film.points(pair.b));
  return (flipped ? -dot(m, n) : dot(m, n)) > least_cosine * length(m) * length(n);
}

// Whether a facet touches a vertex or one of its neighbours.
bool touches_ring(const Film& film, Vertex v, Triangle t) {
  const auto& corners = film.corners(t);
  bool touches = std::find(corners.begin(), corners.end(), v) != corners.end();
  film.for_each_end(v, [&](EdgeEnd end) {
    touches = touches || std::find(corners.begin(), corners.end(), film.head(end.outward())) != corners.end();
  });
  return touches;
}

}  // namespace

// After C. Ericson's case analysis by the signs of barycentric coordinates.
Vec3 nearest_point(const Corners& t, const Vec3& p) {
  const Vec3 ab = t[1] - t[0];
  const Vec3 ac = t[2] - t[0];
  const Vec3 ap = p - t[0];
  const double d1 = dot(ab, ap);
  const double d2 = dot(ac, ap);
  if (d1 <= 0 && d2 <= 0) return t[0];
  const Vec3 bp = p - t[1];
  const double d3 = dot(ab, bp);
  const double d4 = dot(ac, bp);
  if (d3 >= 0 && d4 <= d3) return t[1];
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return t[0] + (d1 / (d1 - d3)) * ab;
  const Vec3 cp = p - t[2];
  const double d5 = dot(ab, cp);
  const double d6 = dot(ac, cp);
  if (d6 >= 0 && d5 <= d6) return t[2];
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return t[0] + (d2 / (d2 - d6)) * ac;
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0)
    return t[1] + ((d4 - d3) / ((d4 - d3) + (d5 - d6))) * (t[2] - t[1]);
  const double sum = va + vb + vc;
  return t[0] + (vb / sum) * ab + (vc / sum) * ac;
}

void Proximity::update(const Film& film, std::span<const FacetPair> facets) {
  connectivity_ = film.connectivity_revision();
  pairs_.clear();
  contacts_.clear();
  const std::span<const double> sizes = film.columns(film::ElementKind::vertex).reals(size_column);
  const auto size = [&](Vertex v) {
    return !sizes.empty() && sizes[v.index] > 0 ? sizes[v.index] : size_of(film, v);
  };
  const auto look_at = [&](Vertex v, Triangle t) {
    const auto& corners = film.corners(t);
    const double least = std::min({size(v), size(corners[0]), size(corners[1]), size(corners[2])});
    const double most = reach_ * size(v) + margin_ * least;
    const Corners points = film.points(t);
    const Vec3& p = film.position(v);
    const Vec3 way = p - nearest_point(points, p);
    if (squared_length(way) < most * most && faces(points, way) && !touches_ring(film, v, t))
      pairs_.push_back({v, t});
  };
  for (FacetPair pair : facets) {
    const double most = reach_ + margin_;
    const auto is_far = [&](Triangle t) {
      const auto& corners = film.corners(t);
      return std::all_of(corners.begin(), corners.end(), [&](Vertex v) { return pair.gap > most * size(v); });
    };
    if (is_far(pair.a) && is_far(pair.b)) continue;
    pair.gap = std::max(pair.gap, gap_at_least(film.points(pair.a), film.points(pair.b)));
    const bool a_far = is_far(pair.a);
    const bool b_far = is_far(pair.b);
    if ((a_far && b_far) || are_one_sheet(film, pair)) continue;
    if (!a_far) {
      for (const Vertex v : film.corners(pair.a)) look_at(v, pair.b);
    }
    if (!b_far) {
      for (const Vertex v : film.corners(pair.b)) look_at(v, pair.a);
    }
  }
  std::sort(pairs_.begin(), pairs_.end());
  pairs_.erase(std::unique(pairs_.begin(), pairs_.end()), pairs_.end());
  for (const NearPair& pair : pairs_) {
    const Vec3& p = film.position(pair.vertex);
    const Vec3 place = nearest_point(film.points(pair.facet), p);
    const double distance = length(p - place);
    if (distance < reach_ * size(pair.vertex)) contacts_.push_back({pair, distance, place});
  }
  std::stable_sort(contacts_.begin(), contacts_.end(),
                   [](const Contact& a, const Contact& b) { return a.distance < b.distance; });
}

}  // namespace lamella::surgery
