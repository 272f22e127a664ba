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

}  // namespace lamella::film
