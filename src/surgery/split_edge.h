// One edge divided in two, with all films around it.
#pragma once

#include "film/film.h"

namespace lamella::surgery {

// Puts a vertex at a point of an edge and cuts every facet around it in two. The edge keeps its id for the
// half at its tail, each facet for the part at the edge's head; the new half, the new inner edges and the
// other parts are new elements. Order around borders is kept: both halves carry the sides in the ring order
// of the whole edge.
film::Vertex split_edge(film::Film& film, film::Edge edge, const film::Vec3& point);

// The same at the middle of the edge.
film::Vertex split_edge(film::Film& film, film::Edge edge);

}  // namespace lamella::surgery
