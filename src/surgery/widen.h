// Vertices moved within their films until no angle near them is small.
#pragma once

#include "film/film.h"

namespace lamella::surgery {

// Moves the corners of facets that have an angle below `wanted` (radians), one after another, each to where
// the smallest angle around it is larger: inside a film within its tangent plane, on a border or rim along
// that; others (quad points, fixed vertices, ends of wires) stay. No facet turns over. Goes on while that
// helps. Where averaging (average.h) draws a mesh together, around a vertex with few or many facets, this
// opens it again. Volumes change to second order: restore them afterwards.
//
// Returns the number of moves.
std::uint32_t widen_angles(film::Film& film, double wanted);

}  // namespace lamella::surgery
