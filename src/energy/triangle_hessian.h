// Second derivatives of what a triangle or an edge has: area, volume, length. Arithmetic on points.
#pragma once

#include <array>

#include "energy/triangle.h"
#include "film/mat3.h"

namespace lamella::energy {

using film::Mat3;

// Blocks [i][j] = d2/d(corner i)d(corner j); [j][i] is the transpose of [i][j].
using TriangleHessian = std::array<std::array<Mat3, 3>, 3>;

// With e_i the edge opposite to corner i, run counterclockwise, and the unit normal n, the gradient is
// n x e_i / 2. Moving corner j by v turns the area vector by e_j x v / 2, of which only a normal v turns n,
// hence block ij is (e_i . e_j)/(4 area) n n^T + eps_ij/2 [n]x, where eps_ij is +1 if e_i ends at corner j,
// -1 if it begins there, and 0 for i = j. A triangle without area gets zero.
inline TriangleHessian triangle_area_hessian(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 doubled = double_area_vector(a, b, c);
  const double size = length(doubled);
  if (!(size > 0)) return {};
  const Vec3 n = doubled / size;
  const std::array<Vec3, 3> edge{c - b, a - c, b - a};
  const Mat3 along = outer((0.5 / size) * n, n);
  const Mat3 turn = film::cross_matrix(0.5 * n);
  TriangleHessian h;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t next = (i + 1) % 3;
    h[i][i] = dot(edge[i], edge[i]) * along;
    h[i][next] = dot(edge[i], edge[next]) * along - turn;  // e_i begins at the next corner
    h[next][i] = transposed(h[i][next]);
  }
  return h;
}

// How that changes when the first corner moves by w.
inline TriangleHessian triangle_area_hessian_change(const Vec3& a, const Vec3& b, const Vec3& c,
                                                    const Vec3& w) {
  const Vec3 doubled = double_area_vector(a, b, c);
  const double size = length(doubled);
  if (!(size > 0)) return {};
  const Vec3 n = doubled / size;
  const std::array<Vec3, 3> edge{c - b, a - c, b - a};
  const std::array<Vec3, 3> edge_change{Vec3{}, w, -w};
  const Vec3 doubled_change = cross(edge[0], w);
  const double growth = dot(n, doubled_change) / size;
  const Vec3 tilt = doubled_change / size - growth * n;
  const Mat3 along = outer((0.5 / size) * n, n);
  const Mat3 along_change = (-growth) * along + (0.5 / size) * (outer(tilt, n) + outer(n, tilt));
  const Mat3 turn_change = film::cross_matrix(0.5 * tilt);
  TriangleHessian h;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t next = (i + 1) % 3;
    h[i][i] = 2 * dot(edge[i], edge_change[i]) * along + dot(edge[i], edge[i]) * along_change;
    h[i][next] = (dot(edge_change[i], edge[next]) + dot(edge[i], edge_change[next])) * along +
                 dot(edge[i], edge[next]) * along_change - turn_change;
    h[next][i] = transposed(h[i][next]);
  }
  return h;
}

// Constant in each corner's own position: block ij is eps_ij [k]x with the third corner k.
constexpr TriangleHessian sixfold_volume_hessian(const Vec3& a, const Vec3& b, const Vec3& c) {
  const std::array<Vec3, 3> corner{a, b, c};
  TriangleHessian h{};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t next = (i + 1) % 3;
    h[next][i] = film::cross_matrix(corner[(i + 2) % 3]);
    h[i][next] = transposed(h[next][i]);
  }
  return h;
}

// d2(length)/d(head)d(head), which is that of the tail, and minus the mixed block. No length, no derivative.
inline Mat3 edge_length_hessian(const Vec3& tail, const Vec3& head) {
  const double size = length(head - tail);
  if (!(size > 0)) return {};
  const Vec3 along = (head - tail) / size;
  return (1 / size) * (film::identity3() - outer(along, along));
}

}  // namespace lamella::energy
