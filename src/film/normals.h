// Normals of a film at its vertices.
#pragma once

#include <span>
#include <vector>

#include "film/film.h"

namespace lamella::film {

// For each vertex the sum of the vector areas of the triangles around it, each turned to agree with the sum
// so far: facets of one film may be listed with either orientation. Means what it says inside films only;
// zero where nothing is around.
std::vector<Vec3> area_vectors(const Film& film, std::span<const Vec3> positions);

// Normal to a facet and twice as long as its area, by the right-hand rule from the order of its corners.
inline Vec3 double_area_vector(const Film& film, Triangle t) {
  const std::array<Vec3, 3> p = film.points(t);
  return cross(p[1] - p[0], p[2] - p[0]);
}

}  // namespace lamella::film
