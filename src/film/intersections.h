// Where a film passes through itself.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "film/film.h"

namespace lamella::film {

// A facet as it is, or as it might be.
struct FacetShape {
  std::array<Vertex, 3> corners;
  std::array<Vec3, 3> points;
};
FacetShape shape_of(const Film& film, Triangle t);

// Whether two facets have points in common besides the corners and edges they share. Touching counts.
bool facets_cross(const Film& film, Triangle a, Triangle b);
bool shapes_cross(const FacetShape& a, const FacetShape& b);

// Pairs of facets that cross, at most so many: n log n where there are few.
std::vector<std::pair<Triangle, Triangle>> self_intersections(const Film& film, std::size_t most = 20);

// The same between some facets and all.
std::vector<std::pair<Triangle, Triangle>> self_intersections(const Film& film, std::span<const Triangle> of,
                                                              std::size_t most = 20);

}  // namespace lamella::film
