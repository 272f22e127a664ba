#include "surgery/wedge.h"

#include <algorithm>
#include <cmath>

namespace lamella::surgery {

using film::Edge;
using film::Film;
using film::Side;
using film::Triangle;
using film::Vec3;

Vec3 across(const Film& film, Side s) {
  const Vec3 axis = unit(film.vector(film.edge_of(s)));
  const auto p = film.points(s.triangle());
  const auto k = static_cast<std::size_t>(s.corner());
  const Vec3 d = p[(k + 2) % 3] - p[k];
  return unit(d - dot(d, axis) * axis);
}

double narrowest_wedge(const Film& film, Edge e) {
  const Side first = film.first_side(e);
  if (!first.valid()) return M_PI;
  const Side second = film.next_around(first);
  if (second == first || film.next_around(second) == first) return M_PI;
  double least = M_PI;
  film.for_each_side(e, [&](Side s) {
    least = std::min(least, angle_between(across(film, s), across(film, film.next_around(s))));
  });
  return least;
}

bool has_narrow_wedge(const Film& film, std::span<const Triangle> facets, double angle) {
  return std::any_of(facets.begin(), facets.end(), [&](Triangle t) {
    const auto& edges = film.edges(t);
    return std::any_of(edges.begin(), edges.end(),
                       [&](film::SignedEdge e) { return narrowest_wedge(film, e.edge()) < angle; });
  });
}

bool turns_once(const Vec3& axis, std::span<const Vec3> directions, double least) {
  double total = 0;
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const Vec3& from = directions[i];
    const Vec3& to = directions[(i + 1) % directions.size()];
    double angle = std::atan2(dot(cross(from, to), axis), dot(from, to) - dot(from, axis) * dot(to, axis));
    if (angle < 0) angle += 2 * M_PI;
    if (angle < least) return false;
    total += angle;
  }
  return total < 3 * M_PI;
}

}  // namespace lamella::surgery
