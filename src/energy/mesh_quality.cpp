#include "energy/mesh_quality.h"

#include <algorithm>
#include <cmath>

namespace lamella::energy {

using film::Vec3;

double largest_cotangent(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 ab = b - a;
  const Vec3 bc = c - b;
  const Vec3 ca = a - c;
  const double largest = std::max({-dot(ab, bc), -dot(bc, ca), -dot(ca, ab)});
  const double doubled = length(cross(ab, ca));
  return doubled > 0 ? largest / doubled : HUGE_VAL;
}

double smallest_angle(const film::Film& film) {
  // The smallest angle has the largest cotangent.
  double cotangent = -HUGE_VAL;
  const auto fixed = film.columns(film::ElementKind::vertex).flags("fixed");
  const auto held = [&](film::Vertex v) { return !fixed.empty() && fixed[v.index] != 0; };
  for (std::uint32_t t = 0; t < film.triangle_rows(); ++t) {
    const auto& c = film.corners(film::Triangle(t));
    if (!c[0].valid() || (held(c[0]) && held(c[1]) && held(c[2]))) continue;
    const std::array<film::Vec3, 3> p = film.points(film::Triangle(t));
    cotangent = std::max(cotangent, largest_cotangent(p[0], p[1], p[2]));
  }
  return cotangent == -HUGE_VAL ? M_PI : std::atan2(1.0, cotangent);
}

EdgeLengths edge_lengths(const film::Film& film) {
  EdgeLengths lengths{HUGE_VAL, 0};
  for (std::uint32_t e = 0; e < film.edge_rows(); ++e) {
    if (!film.alive(film::Edge(e))) continue;
    const double l = length(film.vector(film::Edge(e)));
    lengths.shortest = std::min(lengths.shortest, l);
    lengths.longest = std::max(lengths.longest, l);
  }
  return lengths.longest > 0 ? lengths : EdgeLengths{};
}

}  // namespace lamella::energy
