// Four doubles side by side, and the moves between "one triangle a lane" and "one vertex a line".
//
// Plain compiler vectors: a register where the machine has them (AVX), two where it has not. Wider ones gain
// nothing here, since the time goes into gathering and scattering.
#pragma once

#include <array>
#include <cmath>
#include <cstring>
#include <span>

#include "film/vec3.h"

namespace lamella::energy {

inline constexpr std::size_t lanes = 4;
using Lane [[gnu::vector_size(lanes * sizeof(double))]] = double;

struct Lane3 {
  Lane x;
  Lane y;
  Lane z;
};

inline Lane3 operator-(const Lane3& a, const Lane3& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline Lane3 operator*(const Lane3& a, const Lane& s) {
  return {a.x * s, a.y * s, a.z * s};
}
inline Lane dot(const Lane3& a, const Lane3& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline Lane3 cross(const Lane3& a, const Lane3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

inline Lane square_root(const Lane& a) {
  Lane result;
  for (std::size_t i = 0; i < lanes; ++i) result[i] = std::sqrt(a[i]);
  return result;
}

inline double sum(const Lane& a) {
  return (a[0] + a[1]) + (a[2] + a[3]);
}

// Rows and columns exchanged.
inline std::array<Lane, 4> transposed(const Lane& a, const Lane& b, const Lane& c, const Lane& d) {
  const Lane ab_even = __builtin_shufflevector(a, b, 0, 4, 2, 6);
  const Lane ab_odd = __builtin_shufflevector(a, b, 1, 5, 3, 7);
  const Lane cd_even = __builtin_shufflevector(c, d, 0, 4, 2, 6);
  const Lane cd_odd = __builtin_shufflevector(c, d, 1, 5, 3, 7);
  return {__builtin_shufflevector(ab_even, cd_even, 0, 1, 4, 5),
          __builtin_shufflevector(ab_odd, cd_odd, 0, 1, 4, 5),
          __builtin_shufflevector(ab_even, cd_even, 2, 3, 6, 7),
          __builtin_shufflevector(ab_odd, cd_odd, 2, 3, 6, 7)};
}

// A position in the first three places. The fourth is whatever follows it in memory: one load of 32 bytes
// costs less than three of 8, so only the very last position is read piece by piece.
inline Lane load(std::span<const film::Vec3> positions, std::size_t row) {
  if (row + 1 < positions.size()) [[likely]] {
    Lane p;
    std::memcpy(&p, positions.data() + row, sizeof p);
    return p;
  }
  const film::Vec3& last = positions[row];
  return Lane{last.x, last.y, last.z, 0.0};
}

// Four numbers that lie aligned or not, as positions and velocities of lines do.
inline Lane lane_at(const double* four) {
  Lane value;
  std::memcpy(&value, four, sizeof value);
  return value;
}

inline Lane lane_of(const film::Vec3& v) {
  return Lane{v.x, v.y, v.z, 0.0};
}
inline film::Vec3 vector_of(const Lane& v) {
  return {v[0], v[1], v[2]};
}
inline double sum_of_3(const Lane& v) {
  return v[0] + v[1] + v[2];
}

inline void add_to(double* four, const Lane& share) {
  Lane value;
  std::memcpy(&value, four, sizeof value);
  value += share;
  std::memcpy(four, &value, sizeof value);
}

}  // namespace lamella::energy
