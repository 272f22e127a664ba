#include "film/predicates.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace lamella::film {

namespace {

constexpr double ulp = std::numeric_limits<double>::epsilon() / 2;

// A sum of doubles that do not overlap, smallest first; the last has the sign of the whole. Room for the
// product of three differences and for three such products.
class Expansion {
 public:
  Expansion() = default;
  // a - b, exactly.
  Expansion(double a, double b) {
    const double sum = a - b;
    const double virtual_b = a - sum;
    const double rest = (a - (sum + virtual_b)) + (virtual_b - b);
    append(rest);
    append(sum);
  }

  int sign() const {
    if (size_ == 0) return 0;
    return part_[size_ - 1] > 0 ? 1 : -1;
  }

  // Adds one number.
  void add(double number) {
    double carry = number;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < size_; ++i) {
      const double sum = carry + part_[i];
      const double virtual_b = sum - carry;
      const double rest = (carry - (sum - virtual_b)) + (part_[i] - virtual_b);
      carry = sum;
      if (rest != 0) part_[kept++] = rest;
    }
    size_ = kept;
    append(carry);
  }
  void add(const Expansion& other, double factor = 1) {
    for (std::size_t i = 0; i < other.size_; ++i) add(factor * other.part_[i]);
  }

  friend Expansion product(const Expansion& a, const Expansion& b) {
    Expansion result;
    for (std::size_t i = 0; i < a.size_; ++i) {
      for (std::size_t k = 0; k < b.size_; ++k) {
        const double high = a.part_[i] * b.part_[k];
        result.add(std::fma(a.part_[i], b.part_[k], -high));
        result.add(high);
      }
    }
    return result;
  }

 private:
  void append(double number) {
    if (number != 0) part_[size_++] = number;
  }

  std::array<double, 200> part_;
  std::size_t size_ = 0;
};

Expansion minor_of(const Expansion& a, const Expansion& b, const Expansion& c, const Expansion& d) {
  Expansion result = product(a, d);
  result.add(product(b, c), -1);
  return result;
}

int exact_orientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const Expansion ax(a.x, d.x), ay(a.y, d.y), az(a.z, d.z);
  const Expansion bx(b.x, d.x), by(b.y, d.y), bz(b.z, d.z);
  const Expansion cx(c.x, d.x), cy(c.y, d.y), cz(c.z, d.z);
  Expansion sum = product(ax, minor_of(by, bz, cy, cz));
  sum.add(product(bx, minor_of(cy, cz, ay, az)));
  sum.add(product(cx, minor_of(ay, az, by, bz)));
  return sum.sign();
}

int sign_of(double number) {
  return number > 0 ? 1 : number < 0 ? -1 : 0;
}

// The axis along which a triangle is seen largest.
int best_axis(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 n = cross(b - a, c - a);
  const double x = std::abs(n.x);
  const double y = std::abs(n.y);
  const double z = std::abs(n.z);
  return x >= y && x >= z ? 0 : y >= z ? 1 : 2;
}

bool segments_meet(int axis, const Vec3& p, const Vec3& q, const Vec3& a, const Vec3& b) {
  const int pa = orientation_along(axis, p, q, a);
  const int pb = orientation_along(axis, p, q, b);
  const int ap = orientation_along(axis, a, b, p);
  const int aq = orientation_along(axis, a, b, q);
  if (pa * pb > 0 || ap * aq > 0) return false;
  if (pa != 0 || pb != 0) return true;
  for (int k = 0; k < 3; ++k) {  // on one line
    if (k == axis) continue;
    if (std::max(p[k], q[k]) < std::min(a[k], b[k]) || std::max(a[k], b[k]) < std::min(p[k], q[k]))
      return false;
  }
  return true;
}

bool inside(int axis, const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const int u = orientation_along(axis, a, b, p);
  const int v = orientation_along(axis, b, c, p);
  const int w = orientation_along(axis, c, a, p);
  return (u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0);
}

bool meets_in_plane(const Vec3& p, const Vec3& q, const Vec3& a, const Vec3& b, const Vec3& c) {
  const int axis = best_axis(a, b, c);
  return inside(axis, p, a, b, c) || inside(axis, q, a, b, c) || segments_meet(axis, p, q, a, b) ||
         segments_meet(axis, p, q, b, c) || segments_meet(axis, p, q, c, a);
}

}  // namespace

int orientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const Vec3 u = a - d;
  const Vec3 v = b - d;
  const Vec3 w = c - d;
  const double yz = v.y * w.z - v.z * w.y;
  const double zx = w.y * u.z - w.z * u.y;
  const double xy = u.y * v.z - u.z * v.y;
  const double value = u.x * yz + v.x * zx + w.x * xy;
  const double size = std::abs(u.x) * (std::abs(v.y * w.z) + std::abs(v.z * w.y)) +
                      std::abs(v.x) * (std::abs(w.y * u.z) + std::abs(w.z * u.y)) +
                      std::abs(w.x) * (std::abs(u.y * v.z) + std::abs(u.z * v.y));
  if (std::abs(value) > 8 * ulp * size) return sign_of(value);
  return exact_orientation(a, b, c, d);
}

int orientation_along(int axis, const Vec3& a, const Vec3& b, const Vec3& c) {
  const int i = (axis + 1) % 3;
  const int k = (axis + 2) % 3;
  const double left = (a[i] - c[i]) * (b[k] - c[k]);
  const double right = (a[k] - c[k]) * (b[i] - c[i]);
  const double value = left - right;
  if (std::abs(value) > 4 * ulp * (std::abs(left) + std::abs(right))) return sign_of(value);
  return minor_of(Expansion(a[i], c[i]), Expansion(a[k], c[k]), Expansion(b[i], c[i]), Expansion(b[k], c[k]))
      .sign();
}

bool segment_meets_triangle(const Vec3& p, const Vec3& q, const Vec3& a, const Vec3& b, const Vec3& c) {
  const int at_p = orientation(a, b, c, p);
  const int at_q = orientation(a, b, c, q);
  if (at_p * at_q > 0) return false;
  if (at_p == 0 && at_q == 0) return meets_in_plane(p, q, a, b, c);
  const int ab = orientation(p, q, a, b);
  const int bc = orientation(p, q, b, c);
  const int ca = orientation(p, q, c, a);
  return (ab >= 0 && bc >= 0 && ca >= 0) || (ab <= 0 && bc <= 0 && ca <= 0);
}

}  // namespace lamella::film
