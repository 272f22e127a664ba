#include "energy/gravity.h"

namespace lamella::energy {

namespace {

// z-component of twice the vector area.
double double_shadow(const Vec3& a, const Vec3& b, const Vec3& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

double square_sum(const Vec3& a, const Vec3& b, const Vec3& c) {
  return a.z * a.z + b.z * b.z + c.z * c.z + a.z * b.z + b.z * c.z + c.z * a.z;
}

}  // namespace

double height_integral(const Vec3& a, const Vec3& b, const Vec3& c) {
  return double_shadow(a, b, c) * square_sum(a, b, c) / 24;
}

std::array<Vec3, 3> height_integral_gradient(const Vec3& a, const Vec3& b, const Vec3& c) {
  const double shadow = double_shadow(a, b, c) / 24;
  const double squares = square_sum(a, b, c) / 24;
  const double heights = a.z + b.z + c.z;
  return {Vec3{(b.y - c.y) * squares, (c.x - b.x) * squares, (a.z + heights) * shadow},
          Vec3{(c.y - a.y) * squares, (a.x - c.x) * squares, (b.z + heights) * shadow},
          Vec3{(a.y - b.y) * squares, (b.x - a.x) * squares, (c.z + heights) * shadow}};
}

}  // namespace lamella::energy
