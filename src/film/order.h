// Spatial order: rows that are near in space made near in memory.
#pragma once

#include "film/film.h"

namespace lamella::film {

// Puts a compact film's rows into an order in which a sweep over the triangles touches vertices that lie
// close together in memory (a Hilbert curve through the vertices; edges and triangles by their first
// vertex). Numbers that people see stay with their elements. Shuffled rows cost a sweep of a million
// facets several times more; below about 100k facets everything is in cache and order does not matter.
void restore_spatial_order(Film& film);

// The mean distance in rows between the corners of a triangle: a measure of how scattered a film is.
double mean_row_distance(const Film& film);

}  // namespace lamella::film
