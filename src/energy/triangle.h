// The area of one triangle and its derivatives: arithmetic on points, no mesh in sight.
#pragma once

#include <array>

#include "film/vec3.h"

namespace lamella::energy {

using film::Vec3;

// Twice the vector area: its length is twice the area, its direction the normal by the right-hand rule.
constexpr Vec3 double_area_vector(const Vec3& a, const Vec3& b, const Vec3& c) {
  return cross(b - a, c - a);
}

inline double triangle_area(const Vec3& a, const Vec3& b, const Vec3& c) {
  return 0.5 * length(double_area_vector(a, b, c));
}

// d(area)/d(corner), one row a corner: half the unit normal times the opposite edge. A triangle without
// area has no gradient; it gets zero.
inline std::array<Vec3, 3> triangle_area_gradient(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 half_normal = 0.5 * unit(double_area_vector(a, b, c));
  return {cross(half_normal, c - b), cross(half_normal, a - c), cross(half_normal, b - a)};
}

// Six times the signed volume of the tetrahedron from the origin over the triangle: positive where the normal
// points away from the origin. Summed over the films of a closed body, with outward normals, it is six times
// the volume, wherever the origin lies.
constexpr double sixfold_volume(const Vec3& a, const Vec3& b, const Vec3& c) {
  return dot(a, cross(b, c));
}

// d(sixfold volume)/d(corner).
constexpr std::array<Vec3, 3> sixfold_volume_gradient(const Vec3& a, const Vec3& b, const Vec3& c) {
  return {cross(b, c), cross(c, a), cross(a, b)};
}

// The smallest interior angle, in radians.
inline double smallest_angle(const Vec3& a, const Vec3& b, const Vec3& c) {
  return std::fmin(angle_between(b - a, c - a),
                   std::fmin(angle_between(c - b, a - b), angle_between(a - c, b - c)));
}

}  // namespace lamella::energy
