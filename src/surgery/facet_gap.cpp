#include "surgery/facet_gap.h"

#include <algorithm>
#include <cmath>

#include "surgery/proximity.h"
#include "surgery/wedge.h"

namespace lamella::surgery {

using film::Film;
using film::Side;
using film::SignedEdge;
using film::Triangle;
using film::Vec3;
using film::Vertex;

namespace {

constexpr int most_advances = 64;
constexpr int most_rounds = 12;    // for a plane between two facets, by E. G. Gilbert's steps
constexpr double near_best = 0.2;  // of the distance of the plane
constexpr double touching = 1e-7;  // of the way in a move and the size of the facets

struct Span {
  double low;
  double high;
};

Span span_along(const Vec3& axis, const Corners& p) {
  const double a = dot(axis, p[0]);
  const double b = dot(axis, p[1]);
  const double c = dot(axis, p[2]);
  return {std::min({a, b, c}), std::max({a, b, c})};
}

// Along an axis of any length.
double gap_along(const Vec3& axis, const Corners& a, const Corners& b) {
  const double l = length(axis);
  if (!(l > 0)) return 0;
  const Span first = span_along(axis, a);
  const Span second = span_along(axis, b);
  return std::max(second.low - first.high, first.low - second.high) / l;
}

Vec3 normal(const Corners& p) {
  return cross(p[1] - p[0], p[2] - p[0]);
}

double box_gap(const Corners& a, const Corners& b) {
  double sum = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const Span first{std::min({a[0][axis], a[1][axis], a[2][axis]}),
                     std::max({a[0][axis], a[1][axis], a[2][axis]})};
    const Span second{std::min({b[0][axis], b[1][axis], b[2][axis]}),
                      std::max({b[0][axis], b[1][axis], b[2][axis]})};
    const double gap = std::max({0.0, second.low - first.high, first.low - second.high});
    sum += gap * gap;
  }
  return std::sqrt(sum);
}

// The distance of the segments p to p + u and q to q + w.
double segment_distance(const Vec3& p, const Vec3& u, const Vec3& q, const Vec3& w) {
  const Vec3 between = p - q;
  const double uu = dot(u, u);
  const double ww = dot(w, w);
  const double uw = dot(u, w);
  const double ub = dot(u, between);
  const double wb = dot(w, between);
  const double det = uu * ww - uw * uw;
  double s = det > 0 ? std::clamp((uw * wb - ub * ww) / det, 0.0, 1.0) : 0.0;
  const double t = ww > 0 ? std::clamp((uw * s + wb) / ww, 0.0, 1.0) : 0.0;
  if (uu > 0) s = std::clamp((uw * t - ub) / uu, 0.0, 1.0);
  return length(between + s * u - t * w);
}

Corners between(const Corners& from, const Corners& to, double part) {
  Corners p;
  for (std::size_t k = 0; k < 3; ++k) p[k] = from[k] + part * (to[k] - from[k]);
  return p;
}

// Turned so that the shared corner comes first.
Corners from_corner(const Corners& p, std::size_t k) {
  return {p[k], p[(k + 1) % 3], p[(k + 2) % 3]};
}

double altitude_over(const Film& film, Side s) {
  const double base = length(film.vector(film.edge_of(s)));
  return base > 0 ? length(normal(film.points(s.triangle()))) / base : 0;
}

}  // namespace

double longest_side(const Corners& p) {
  return std::sqrt(
      std::max({squared_length(p[1] - p[0]), squared_length(p[2] - p[1]), squared_length(p[0] - p[2])}));
}

double gap_at_least(const Corners& a, const Corners& b) {
  double gap = box_gap(a, b);
  gap = std::max(gap, gap_along((b[0] + b[1] + b[2]) - (a[0] + a[1] + a[2]), a, b));
  gap = std::max(gap, gap_along(normal(a), a, b));
  return std::max(gap, gap_along(normal(b), a, b));
}

double distance(const Corners& a, const Corners& b) {
  double least = HUGE_VAL;
  for (std::size_t k = 0; k < 3; ++k) {
    least = std::min(least, length(a[k] - nearest_point(b, a[k])));
    least = std::min(least, length(b[k] - nearest_point(a, b[k])));
    for (std::size_t m = 0; m < 3; ++m)
      least = std::min(least, segment_distance(a[k], a[(k + 1) % 3] - a[k], b[m], b[(m + 1) % 3] - b[m]));
  }
  return least;
}

std::array<double, 2> room_at_corner(const Film& film, Triangle a, Triangle b) {
  const auto& ca = film.corners(a);
  const auto& cb = film.corners(b);
  std::size_t i = 0;
  std::size_t k = 0;
  for (std::size_t m = 0; m < 9; ++m) {
    if (ca[m / 3] != cb[m % 3]) continue;
    i = m / 3;
    k = m % 3;
  }
  const Corners p = from_corner(film.points(a), i);
  const Corners q = from_corner(film.points(b), k);
  const Vec3 own[2] = {p[1] - p[0], p[2] - p[0]};
  const Vec3 others[2] = {q[1] - q[0], q[2] - q[0]};
  // The nearest point to the corner of the hull of ways from it to the other corners, those of one facet
  // reversed, would be the best axis.
  const std::array<Vec3, 4> ways{unit(own[0]), unit(own[1]), -unit(others[0]), -unit(others[1])};
  Vec3 axis = 0.25 * (ways[0] + ways[1] + ways[2] + ways[3]);
  for (int round = 0; round < most_rounds; ++round) {
    const Vec3* lowest = &ways[0];
    for (const Vec3& way : ways) lowest = dot(axis, way) < dot(axis, *lowest) ? &way : lowest;
    const double excess = dot(axis, axis - *lowest);
    if (!(excess > near_best * squared_length(axis))) break;
    axis += std::min(1.0, excess / squared_length(axis - *lowest)) * (*lowest - axis);
  }
  const double l = length(axis);
  if (!(l > 0)) return {0, 0};
  return {std::min(dot(axis, own[0]), dot(axis, own[1])) / l,
          -std::max(dot(axis, others[0]), dot(axis, others[1])) / l};
}

std::array<double, 2> room_at_edge(const Film& film, Triangle a, Triangle b, double part) {
  for (int k = 0; k < 3; ++k) {
    const Side own(a, k);
    for (int m = 0; m < 3; ++m) {
      const Side other(b, m);
      if (film.edge_of(own).edge() != film.edge_of(other).edge()) continue;
      const double turn = part * length(across(film, own) - across(film, other));
      return {turn * altitude_over(film, own), turn * altitude_over(film, other)};
    }
  }
  return {0, 0};  // two corners, and yet no edge
}

bool meet_on_the_way(const Corners& a_from, const Corners& a_to, const Corners& b_from, const Corners& b_to) {
  double way = 0;  // of any two points to each other
  double size = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    size = std::max(size, length(a_from[(k + 1) % 3] - a_from[k]));
    for (std::size_t m = 0; m < 3; ++m)
      way = std::max(way, length((a_to[k] - a_from[k]) - (b_to[m] - b_from[m])));
  }
  if (gap_at_least(a_from, b_from) > way) return false;
  double part = 0;
  for (int advance = 0; advance < most_advances && part < 1; ++advance) {
    const double gap = distance(between(a_from, a_to, part), between(b_from, b_to, part));
    if (gap > (1 - part) * way) return false;
    if (gap < touching * (way + size)) return part > 0;  // as near as at the start, they have not met yet
    part += gap / way;
  }
  return part < 1;
}

}  // namespace lamella::surgery
