#include "energy/angle_sums.h"

#include <cmath>

namespace lamella::energy {

namespace {

using film::Edge;
using film::Film;
using film::Side;

// The rows of an edge's tail and head, in its own direction, and of the corner opposite to it, in a facet.
std::array<std::uint32_t, 3> rows_at(const Film& film, const film::Unfolding& unfolding, Side s) {
  const auto& rows =
      unfolding.empty() ? film.corners(s.triangle()) : unfolding.triangles()[s.triangle().index];
  const auto k = static_cast<std::size_t>(s.corner());
  const std::uint32_t from = rows[k].index;
  const std::uint32_t to = rows[(k + 1) % 3].index;
  const bool reversed = film.edge_of(s).reversed();
  return {reversed ? to : from, reversed ? from : to, rows[(k + 2) % 3].index};
}

}  // namespace

void AngleSums::add_corner(double times, const std::array<film::Vertex, 3>& rows, std::size_t corner) {
  corners_.push_back(
      {{rows[corner].index, rows[(corner + 1) % 3].index, rows[(corner + 2) % 3].index}, times});
}

void AngleSums::add_edge(const Film& film, const film::Unfolding& unfolding, Edge edge, double times) {
  if (film.valence(edge) != 2) return;
  const Side first = film.first_side(edge);
  const Side second = film.next_around(first);
  const double along = film.edge_of(first).reversed() ? -1 : 1;
  hinges_.push_back({rows_at(film, unfolding, first), rows_at(film, unfolding, second), 0.5 * times * along,
                     film.edge_of(first).reversed() != film.edge_of(second).reversed() ? 1.0 : -1.0});
}

double AngleSums::value(std::span<const Vec3> x) const {
  return visit(x, 0, {});
}

double AngleSums::add_gradient(std::span<const Vec3> x, double factor, std::span<Vec3> gradient) const {
  return visit(x, factor, gradient);
}

// With u and v along the sides of a corner and n the unit normal, its angle changes by -(n x u).du/u^2 and
// (n x v).dv/v^2. With e along an edge, a and b the normals e x r and w x e of its facets (r and w lead from
// its tail to their other corners), the angle from a to b about e changes by -|e| a.dr/a^2 - |e| b.dw/b^2
// and, for the head, by (r.e a/a^2 + w.e b/b^2)/|e|; the tail has what makes the sum vanish.
double AngleSums::visit(std::span<const Vec3> x, double factor, std::span<Vec3> gradient) const {
  double sum = constant_;
  const bool wanted = !gradient.empty();
  for (const Corner& corner : corners_) {
    const auto& [a, b, c] = corner.rows;
    const Vec3 u = x[b] - x[a];
    const Vec3 v = x[c] - x[a];
    const Vec3 n = cross(u, v);
    sum += corner.times * std::atan2(length(n), dot(u, v));
    if (!wanted || !(squared_length(n) > 0)) continue;
    const Vec3 unit_normal = unit(n);
    const Vec3 by_b = (-factor * corner.times / squared_length(u)) * cross(unit_normal, u);
    const Vec3 by_c = (factor * corner.times / squared_length(v)) * cross(unit_normal, v);
    gradient[b] += by_b;
    gradient[c] += by_c;
    gradient[a] -= by_b + by_c;
  }
  for (const Hinge& hinge : hinges_) {
    const auto& [p, q, third] = hinge.first;
    const auto& [other_p, other_q, fourth] = hinge.second;
    const Vec3 e = x[q] - x[p];
    const Vec3 r = x[third] - x[p];
    const Vec3 w = x[fourth] - x[other_p];
    const Vec3 a = cross(e, r);
    const Vec3 b = cross(w, e);
    const double size = length(e);
    if (!(size > 0) || !(squared_length(a) > 0) || !(squared_length(b) > 0)) continue;
    const double angle = std::atan2(dot(cross(a, b), e) / size, dot(a, b));
    sum += hinge.times * size * angle;
    if (!wanted) continue;
    const double times = factor * hinge.times;
    const Vec3 by_r = (-times * size * size / squared_length(a)) * a;
    const Vec3 by_w = (-times * size * size / squared_length(b)) * b;
    const Vec3 first_head = (times * dot(r, e) / squared_length(a)) * a;
    const Vec3 second_head = (times * dot(w, e) / squared_length(b)) * b;
    const Vec3 stretch = (times * angle / size) * e;
    gradient[third] += by_r;
    gradient[q] += first_head + stretch;
    gradient[p] -= by_r + first_head + stretch;
    gradient[fourth] += by_w;
    gradient[other_q] += second_head;
    gradient[other_p] -= by_w + second_head;
  }
  return sum;
}

}  // namespace lamella::energy
