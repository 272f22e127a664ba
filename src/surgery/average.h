// Vertices moved to the middle of their neighbours, within their films.
#pragma once

#include "film/film.h"

namespace lamella::surgery {

// Surface Evolver's `V`: all new positions are computed before any vertex moves. A vertex inside a film goes
// to the area- weighted mean of its facets' centroids, less the part along its normal, so that volumes are
// kept to first order; a vertex on a border (or rim) with exactly two border (rim) neighbours goes along the
// border to the mean weighted by length; others (quad points, fixed vertices, ends of wires) stay. Where a
// facet would turn over, its vertices' moves are halved until it does not. Volumes change to second order:
// restore them afterwards.
//
// Returns the number of vertices moved.
std::uint32_t average_vertices(film::Film& film);

}  // namespace lamella::surgery
