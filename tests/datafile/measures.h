// Area and volume of a loaded scene, by formulas of their own.
#pragma once

#include "scene/scene.h"

namespace lamella::test {

inline double area(const scene::Scene& scene) {
  double sum = 0;
  for (std::uint32_t t = 0; t < scene.film.triangle_rows(); ++t) {
    const auto [a, b, c] = scene.film.points(film::Triangle(t));
    sum += 0.5 * length(cross(b - a, c - a));
  }
  return sum;
}

// The flux of (0,0,z) out of a region, or of the position over 3 with symmetric_content.
inline double volume(const scene::Scene& scene, film::Region region) {
  double sum = scene.body(region).volume_offset;
  for (std::uint32_t t = 0; t < scene.film.triangle_rows(); ++t) {
    const film::RegionPair pair = scene.film.regions(film::Triangle(t));
    const int sign = (pair.behind == region ? 1 : 0) - (pair.front == region ? 1 : 0);
    const auto& c = scene.film.corners(film::Triangle(t));
    const film::Vec3 a = scene.film.position(c[0]);
    const film::Vec3 b = scene.film.position(c[1]);
    const film::Vec3 d = scene.film.position(c[2]);
    sum += sign * (scene.symmetric_content ? dot(a, cross(b, d)) / 6
                                           : 0.5 * cross(b - a, d - a).z * (a.z + b.z + d.z) / 3);
  }
  return sum;
}

}  // namespace lamella::test
