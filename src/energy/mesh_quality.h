// How well shaped the triangles of a film are.
#pragma once

#include "film/film.h"

namespace lamella::energy {

// The smallest interior angle of any triangle, in radians; pi for a film without triangles. Triangles whose
// corners are all fixed do not count: nothing can be done about them.
double smallest_angle(const film::Film& film);

// The cotangent of a triangle's smallest angle, the largest of the three: says the same without the cost of
// an arc. Infinite for a triangle without area.
double largest_cotangent(const film::Vec3& a, const film::Vec3& b, const film::Vec3& c);

struct EdgeLengths {
  double shortest = 0;
  double longest = 0;
};
EdgeLengths edge_lengths(const film::Film& film);

}  // namespace lamella::energy
