#include "energy/angle_sums.h"

#include <cmath>

#include "energy/dual.h"

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
  hinges_.push_back({rows_at(film, unfolding, first), rows_at(film, unfolding, second), 0.5 * times * along});
}

double AngleSums::value(std::span<const Vec3> x) const {
  return visit(x, 0, {});
}

double AngleSums::add_gradient(std::span<const Vec3> x, double factor, std::span<Vec3> gradient) const {
  return visit(x, factor, gradient);
}

namespace {

// --- derivatives of an angle between two vectors, and of a length times the angle at it; V is Vec3 or
// DualVec3

// By u and by v: with n the unit normal, -(n x u)/u^2 and (n x v)/v^2.
template <class V>
std::array<V, 2> corner_slopes(const V& u, const V& v) {
  using std::sqrt;
  const V n = cross(u, v);
  const auto size = sqrt(dot(n, n));
  const auto one = size / size;
  return {(-(one / (size * dot(u, u)))) * cross(n, u), (one / (size * dot(v, v))) * cross(n, v)};
}

template <class V>
auto hinge_angle(const V& e, const V& a, const V& b) {
  using std::atan2;
  using std::sqrt;
  return atan2(dot(cross(a, b), e) / sqrt(dot(e, e)), dot(a, b));
}

// With e along an edge and r and w from its tail to the other corners of its facets, whose normals are a = e
// x r and b = w x e, the angle from a to b about e changes by -|e| a.dr/a^2 - |e| b.dw/b^2 and, for the head,
// by (r.e a/a^2 + w.e b/b^2)/|e|. By e, r and w.
template <class V>
std::array<V, 3> hinge_slopes(const V& e, const V& r, const V& w) {
  using std::sqrt;
  const V a = cross(e, r);
  const V b = cross(w, e);
  const auto square = dot(e, e);
  const V along_a = (square / square / dot(a, a)) * a;
  const V along_b = (square / square / dot(b, b)) * b;
  return {dot(r, e) * along_a + dot(w, e) * along_b + (hinge_angle(e, a, b) / sqrt(square)) * e,
          (-square) * along_a, (-square) * along_b};
}

// Second derivatives of what depends on differences of points: `from` and `to` are the points of each.
template <std::size_t n, class SlopesOf>
void add_second(const std::array<Vec3, n>& differences,
                const std::array<std::array<std::uint32_t, 2>, n>& ends, double factor,
                const SlopesOf& slopes_of, HessianSink& sink) {
  std::array<std::array<Mat3, n>, n> second{};  // [i][k] = d2/d(i)d(k), transposed while it is filled
  for (std::size_t k = 0; k < n; ++k) {
    for (int axis = 0; axis < 3; ++axis) {
      std::array<DualVec3, n> moved;
      for (std::size_t i = 0; i < n; ++i) moved[i].value = differences[i];
      moved[k].change[axis] = 1;
      const std::array<DualVec3, n> slopes = slopes_of(moved);
      for (std::size_t i = 0; i < n; ++i)
        (axis == 0   ? second[i][k].x
         : axis == 1 ? second[i][k].y
                     : second[i][k].z) = factor * slopes[i].change;
    }
  }
  const auto add = [&](std::uint32_t u, std::uint32_t v, const Mat3& block, bool twice) {
    sink.add(u, v, twice && u == v ? block + transposed(block) : block);
  };
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = i; k < n; ++k) {
      const Mat3 block = transposed(second[i][k]);
      const auto [from_i, to_i] = ends[i];
      const auto [from_k, to_k] = ends[k];
      add(to_i, to_k, block, i != k);
      add(from_i, from_k, block, i != k);
      add(to_i, from_k, -1 * block, true);
      if (i != k) add(from_i, to_k, -1 * block, true);
    }
  }
}

}  // namespace

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
    const auto [by_u, by_v] = corner_slopes(u, v);
    const double times = factor * corner.times;
    gradient[b] += times * by_u;
    gradient[c] += times * by_v;
    gradient[a] -= times * (by_u + by_v);
  }
  for (const Hinge& hinge : hinges_) {
    const auto arms = arms_of(hinge, x);
    if (!arms) continue;
    const auto& [e, r, w] = *arms;
    sum += hinge.times * length(e) * hinge_angle(e, cross(e, r), cross(w, e));
    if (!wanted) continue;
    const double times = factor * hinge.times;
    const auto [by_e, by_r, by_w] = hinge_slopes(e, r, w);
    gradient[hinge.first[1]] += times * by_e;
    gradient[hinge.first[2]] += times * by_r;
    gradient[hinge.first[0]] -= times * (by_e + by_r);
    gradient[hinge.second[2]] += times * by_w;
    gradient[hinge.second[0]] -= times * by_w;
  }
  return sum;
}

// Along the edge, and from its tail to the other corners; nothing where one of the facets has no area.
std::optional<std::array<Vec3, 3>> AngleSums::arms_of(const Hinge& hinge, std::span<const Vec3> x) {
  const Vec3 e = x[hinge.first[1]] - x[hinge.first[0]];
  const Vec3 r = x[hinge.first[2]] - x[hinge.first[0]];
  const Vec3 w = x[hinge.second[2]] - x[hinge.second[0]];
  if (!(squared_length(cross(e, r)) > 0) || !(squared_length(cross(w, e)) > 0)) return std::nullopt;
  return std::array{e, r, w};
}

void AngleSums::add_hessian(std::span<const Vec3> x, double factor, HessianSink& sink) const {
  for (const Corner& corner : corners_) {
    const auto& [a, b, c] = corner.rows;
    const std::array<Vec3, 2> sides{x[b] - x[a], x[c] - x[a]};
    if (!(squared_length(cross(sides[0], sides[1])) > 0)) continue;
    add_second(
        sides, std::array<std::array<std::uint32_t, 2>, 2>{{{a, b}, {a, c}}}, factor * corner.times,
        [](const std::array<DualVec3, 2>& s) { return corner_slopes(s[0], s[1]); }, sink);
  }
  for (const Hinge& hinge : hinges_) {
    const auto arms = arms_of(hinge, x);
    if (!arms) continue;
    const auto& [p, q, third] = hinge.first;
    const std::uint32_t fourth = hinge.second[2];
    add_second(
        *arms, std::array<std::array<std::uint32_t, 2>, 3>{{{p, q}, {p, third}, {hinge.second[0], fourth}}},
        factor * hinge.times, [](const std::array<DualVec3, 3>& d) { return hinge_slopes(d[0], d[1], d[2]); },
        sink);
  }
}

}  // namespace lamella::energy
