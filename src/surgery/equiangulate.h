// Edges flipped until the triangulation is as equiangular as it can be (Delaunay within each film).
#pragma once

#include "film/film.h"

namespace lamella::surgery {

// True if the angles opposite to the edge sum to more than a half turn, by more than rounding.
struct Diagonal;
bool is_worse_diagonal(const film::Film& film, const Diagonal& diagonal);

// One pass over the edges as they stand: flips each worse diagonal (Surface Evolver's `u`), except where it
// would fold the film. Returns the number of flips. On a flat film repeated passes end in a Delaunay
// triangulation.
std::uint32_t equiangulate(film::Film& film);

// The same for one edge. True if it was flipped.
bool equiangulate(film::Film& film, film::Edge edge);

}  // namespace lamella::surgery
