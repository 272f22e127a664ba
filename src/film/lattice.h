// Periodic films: space repeats itself along three vectors, and an edge may leave through one side of a cell
// and come back through the opposite one.
#pragma once

#include <array>
#include <cmath>
#include <compare>
#include <cstdint>

#include "film/vec3.h"

namespace lamella::film {

// How many periods lie between the tail of an edge and its head: the head stands at its position plus
// wrap.times[i] times period i. Turning the edge over changes the signs.
struct Wrap {
  std::array<std::int32_t, 3> times{};

  constexpr std::int32_t operator[](std::size_t i) const { return times[i]; }
  friend constexpr Wrap operator-(const Wrap& w) { return {{-w[0], -w[1], -w[2]}}; }
  friend constexpr Wrap operator+(const Wrap& a, const Wrap& b) {
    return {{a[0] + b[0], a[1] + b[1], a[2] + b[2]}};
  }
  friend constexpr Wrap operator-(const Wrap& a, const Wrap& b) { return a + (-b); }
  friend constexpr auto operator<=>(const Wrap&, const Wrap&) = default;
};

// The three periods, linearly independent.
class Lattice {
 public:
  explicit Lattice(const std::array<Vec3, 3>& periods) : periods_(periods) {
    const double cell = volume_with_sign();
    for (std::size_t i = 0; i < 3; ++i) dual_[i] = cross(periods[(i + 1) % 3], periods[(i + 2) % 3]) / cell;
  }

  const std::array<Vec3, 3>& periods() const { return periods_; }
  Vec3 shift(const Wrap& w) const {
    return static_cast<double>(w[0]) * periods_[0] + static_cast<double>(w[1]) * periods_[1] +
           static_cast<double>(w[2]) * periods_[2];
  }
  // The wrap whose shift is nearest to a vector, coordinate by coordinate.
  Wrap nearest(const Vec3& v) const {
    Wrap w{};
    for (std::size_t i = 0; i < 3; ++i) w.times[i] = static_cast<std::int32_t>(std::lround(dot(dual_[i], v)));
    return w;
  }
  double volume() const { return std::abs(volume_with_sign()); }

 private:
  double volume_with_sign() const { return dot(periods_[0], cross(periods_[1], periods_[2])); }

  std::array<Vec3, 3> periods_;
  std::array<Vec3, 3> dual_{};  // dual_[i] . periods_[j] is 1 for i = j, else 0
};

}  // namespace lamella::film
