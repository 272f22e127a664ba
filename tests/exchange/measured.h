// Figures of a scene that must survive a file.
#pragma once

#include <cmath>
#include <vector>

#include "scene/scene.h"

namespace lamella::exchange {

struct Measured {
  std::uint32_t vertices = 0;
  std::uint32_t edges = 0;
  std::uint32_t facets = 0;
  std::uint32_t borders = 0;  // edges of three facets or more
  std::uint32_t rims = 0;     // of one
  double area = 0;
  std::vector<double> volumes;  // by region
};

inline Measured measured(const scene::Scene& scene) {
  const film::Film& film = scene.film;
  Measured m{film.vertex_count(), film.edge_count(), film.triangle_count(), 0, 0, 0, {}};
  for (std::uint32_t e = 0; e < film.edge_rows(); ++e) {
    const int sides = film.valence(film::Edge(e));
    if (sides > 2) ++m.borders;
    if (sides == 1) ++m.rims;
  }
  for (std::uint32_t t = 0; t < film.triangle_rows(); ++t) {
    const auto p = film.points(film::Triangle(t));
    const film::RegionPair pair = film.regions(film::Triangle(t));
    m.area += length(cross(p[1] - p[0], p[2] - p[0])) / 2;
    m.volumes.resize(std::max<std::size_t>({m.volumes.size(), pair.front.index + 1, pair.behind.index + 1}));
    const double volume = dot(p[0], cross(p[1], p[2])) / 6;
    m.volumes[pair.behind.index] += volume;
    m.volumes[pair.front.index] -= volume;
  }
  return m;
}

}  // namespace lamella::exchange
