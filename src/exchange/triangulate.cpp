#include <span>

#include "exchange/weld.h"

namespace lamella::exchange {

using film::Vec3;

namespace {

// Twice the vector area, as M. Newell sums it: fair to polygons that are not quite flat.
Vec3 area_vector(const std::vector<Vec3>& points, std::span<const std::uint32_t> polygon) {
  Vec3 sum;
  const Vec3 origin = points[polygon[0]];
  for (std::size_t i = 0; i < polygon.size(); ++i)
    sum += cross(points[polygon[i]] - origin, points[polygon[(i + 1) % polygon.size()]] - origin);
  return sum;
}

// An ear is a corner that bends outwards and whose triangle holds no other corner.
class EarCutter {
 public:
  EarCutter(const std::vector<Vec3>& points, std::span<const std::uint32_t> polygon)
      : points_(points), left_(polygon.begin(), polygon.end()), normal_(area_vector(points, polygon)) {}

  std::vector<Triple> cut() {
    std::vector<Triple> triangles;
    while (left_.size() > 3) {
      std::size_t ear = 0;
      double best = -1;
      for (std::size_t i = 0; i < left_.size(); ++i) {
        const double quality = quality_of(i);
        if (quality > best) {
          best = quality;
          ear = i;
        }
      }
      // Nothing is an ear of a polygon that crosses itself.
      triangles.push_back(corner(ear));
      left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(ear));
    }
    triangles.push_back({left_[0], left_[1], left_[2]});
    return triangles;
  }

 private:
  Triple corner(std::size_t i) const {
    return {left_[(i + left_.size() - 1) % left_.size()], left_[i], left_[(i + 1) % left_.size()]};
  }

  double area(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    return dot(cross(points_[b] - points_[a], points_[c] - points_[a]), normal_);
  }

  // Of the triangle that would be cut off: large for round ones, -1 where it must not be.
  double quality_of(std::size_t i) const {
    const auto [a, b, c] = corner(i);
    const double own = area(a, b, c);
    if (own <= 0) return -1;
    for (const std::uint32_t p : left_) {
      if (p == a || p == b || p == c) continue;
      if (area(a, b, p) >= 0 && area(b, c, p) >= 0 && area(c, a, p) >= 0) return -1;
    }
    const double sides = squared_length(points_[b] - points_[a]) + squared_length(points_[c] - points_[b]) +
                         squared_length(points_[a] - points_[c]);
    return own / sides;
  }

  const std::vector<Vec3>& points_;
  std::vector<std::uint32_t> left_;
  Vec3 normal_;
};

}  // namespace

std::vector<Triple> triangulate(const std::vector<Vec3>& points, std::span<const std::uint32_t> polygon) {
  if (polygon.size() == 3) return {{polygon[0], polygon[1], polygon[2]}};
  return EarCutter(points, polygon).cut();
}

}  // namespace lamella::exchange
