// Facets with a small angle, and edges with a sharp one, divided.
#pragma once

#include "film/film.h"

namespace lamella::surgery {

// Halves the longest edge of each facet whose smallest angle (in radians) is below a bound, each edge once.
// Returns how many.
std::uint32_t divide_skinny_facets(film::Film& film, double angle);

// Cuts in three, each once, the facets at edges with two facets whose normals differ by more than an angle
// (in radians). Returns how many, as Surface Evolver counts.
std::uint32_t notch_edges(film::Film& film, double angle);

// The angle between the normals of the two facets at an edge, seen as one surface; 0 where there are not two.
double fold_angle(const film::Film& film, film::Edge e);

}  // namespace lamella::surgery
