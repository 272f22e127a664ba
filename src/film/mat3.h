// A linear map of space, by rows.
#pragma once

#include <array>

#include "film/vec3.h"

namespace lamella::film {

struct Mat3 {
  Vec3 x;  // rows
  Vec3 y;
  Vec3 z;

  constexpr Mat3& operator+=(const Mat3& b) { return x += b.x, y += b.y, z += b.z, *this; }
  constexpr Mat3& operator-=(const Mat3& b) { return x -= b.x, y -= b.y, z -= b.z, *this; }
  constexpr Mat3& operator*=(double s) { return x *= s, y *= s, z *= s, *this; }

  friend constexpr Mat3 operator+(Mat3 a, const Mat3& b) { return a += b; }
  friend constexpr Mat3 operator-(Mat3 a, const Mat3& b) { return a -= b; }
  friend constexpr Mat3 operator*(double s, Mat3 a) { return a *= s; }
  friend constexpr Vec3 operator*(const Mat3& a, const Vec3& v) {
    return {dot(a.x, v), dot(a.y, v), dot(a.z, v)};
  }
  friend constexpr bool operator==(const Mat3&, const Mat3&) = default;
};

constexpr Mat3 transposed(const Mat3& a) {
  return {{a.x.x, a.y.x, a.z.x}, {a.x.y, a.y.y, a.z.y}, {a.x.z, a.y.z, a.z.z}};
}

constexpr Mat3 identity3() {
  return {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
}

// From xx, xy, xz, yy, yz, zz.
constexpr Mat3 symmetric(const std::array<double, 6>& h) {
  return {{h[0], h[1], h[2]}, {h[1], h[3], h[4]}, {h[2], h[4], h[5]}};
}

// v -> a (b . v)
constexpr Mat3 outer(const Vec3& a, const Vec3& b) {
  return {a.x * b, a.y * b, a.z * b};
}

// v -> w x v
constexpr Mat3 cross_matrix(const Vec3& w) {
  return {{0, -w.z, w.y}, {w.z, 0, -w.x}, {-w.y, w.x, 0}};
}

}  // namespace lamella::film
