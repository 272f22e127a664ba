// Numbers and vectors with a change that they undergo: derivatives in one direction, exact.
#pragma once

#include <cmath>

#include "film/vec3.h"

namespace lamella::energy {

struct Dual {
  double value = 0;
  double change = 0;
};

struct DualVec3 {
  film::Vec3 value;
  film::Vec3 change;
};

inline Dual operator-(const Dual& a) {
  return {-a.value, -a.change};
}
inline Dual operator*(const Dual& a, const Dual& b) {
  return {a.value * b.value, a.value * b.change + a.change * b.value};
}
inline Dual operator/(const Dual& a, const Dual& b) {
  const double q = a.value / b.value;
  return {q, (a.change - q * b.change) / b.value};
}
inline Dual sqrt(const Dual& a) {
  const double root = std::sqrt(a.value);
  return {root, 0.5 * a.change / root};
}
inline Dual atan2(const Dual& y, const Dual& x) {
  const double square = x.value * x.value + y.value * y.value;
  return {std::atan2(y.value, x.value), (x.value * y.change - y.value * x.change) / square};
}

inline DualVec3 operator+(const DualVec3& a, const DualVec3& b) {
  return {a.value + b.value, a.change + b.change};
}
inline DualVec3 operator*(const Dual& s, const DualVec3& a) {
  return {s.value * a.value, s.value * a.change + s.change * a.value};
}
inline Dual dot(const DualVec3& a, const DualVec3& b) {
  return {dot(a.value, b.value), dot(a.value, b.change) + dot(a.change, b.value)};
}
inline DualVec3 cross(const DualVec3& a, const DualVec3& b) {
  return {cross(a.value, b.value), cross(a.value, b.change) + cross(a.change, b.value)};
}

}  // namespace lamella::energy
