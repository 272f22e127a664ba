// Vertices drawn toward their neighbours: the averaging of scripts written for Surface Evolver, in steps of a
// quarter. (average.h goes all the way at once.)
#pragma once

#include "film/film.h"

namespace lamella::surgery {

enum class Averaging : std::uint8_t {
  free,         // as the mean says
  keep_volume,  // less what would change volumes to first order: along the normal, or across a border
};

// The move of a vertex, a quarter of the way to a mean of its neighbours:
//   inside a film: each neighbour weighs as the square of the area of the two facets at the edge to it
//   on a border, with exactly two borders going on: those two neighbours
//   on a rim: all neighbours
//   on constraints or a boundary: as on a rim, of the neighbours that are on them too
// Fixed vertices, ends of wires, quad points stay.
film::Vec3 averaging_move(const film::Film& film, film::Vertex v, Averaging averaging);

// All vertices at once: every move is known before any is made. Returns how many moved.
std::uint32_t smooth_vertices(film::Film& film, Averaging averaging);

}  // namespace lamella::surgery
