#include "energy/mesh_quality.h"

#include <algorithm>
#include <cmath>

#include "energy/triangle.h"

namespace lamella::energy {

double smallest_angle(const film::Film& film) {
  double smallest = M_PI;
  const auto fixed = film.columns(film::ElementKind::vertex).flags("fixed");
  const auto held = [&](film::Vertex v) { return !fixed.empty() && fixed[v.index] != 0; };
  for (const auto& c : film.connectivity().triangle_vertices) {
    if (!c[0].valid() || (held(c[0]) && held(c[1]) && held(c[2]))) continue;
    smallest =
        std::min(smallest, smallest_angle(film.position(c[0]), film.position(c[1]), film.position(c[2])));
  }
  return smallest;
}

EdgeLengths edge_lengths(const film::Film& film) {
  EdgeLengths lengths{HUGE_VAL, 0};
  for (const auto& ends : film.connectivity().edge_vertices) {
    if (!ends[0].valid()) continue;
    const double l = length(film.position(ends[1]) - film.position(ends[0]));
    lengths.shortest = std::min(lengths.shortest, l);
    lengths.longest = std::max(lengths.longest, l);
  }
  return lengths.longest > 0 ? lengths : EdgeLengths{};
}

}  // namespace lamella::energy
