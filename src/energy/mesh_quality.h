// How well shaped the triangles of a film are.
#pragma once

#include "film/film.h"

namespace lamella::energy {

// The smallest interior angle of any triangle, in radians; pi for a film without triangles. Triangles whose
// corners are all fixed do not count: nothing can be done about them.
double smallest_angle(const film::Film& film);

struct EdgeLengths {
  double shortest = 0;
  double longest = 0;
};
EdgeLengths edge_lengths(const film::Film& film);

}  // namespace lamella::energy
