#include "energy/mesh_quality.h"

#include <algorithm>
#include <cmath>

#include "energy/triangle.h"

namespace lamella::energy {

double smallest_angle(const film::Film& film) {
  double smallest = M_PI;
  const auto fixed = film.columns(film::ElementKind::vertex).flags("fixed");
  const auto held = [&](film::Vertex v) { return !fixed.empty() && fixed[v.index] != 0; };
  for (std::uint32_t t = 0; t < film.triangle_rows(); ++t) {
    const auto& c = film.corners(film::Triangle(t));
    if (!c[0].valid() || (held(c[0]) && held(c[1]) && held(c[2]))) continue;
    const std::array<film::Vec3, 3> p = film.points(film::Triangle(t));
    smallest = std::min(smallest, smallest_angle(p[0], p[1], p[2]));
  }
  return smallest;
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
