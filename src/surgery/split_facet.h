// One facet cut in three around a new vertex.
#pragma once

#include "film/film.h"

namespace lamella::surgery {

// Puts a vertex at a facet's centroid with an edge from each corner to it. The facet keeps its id for the
// part at its last edge, as the datafile reader does for faces of many edges.
film::Vertex split_facet(film::Film& film, film::Triangle facet);

}  // namespace lamella::surgery
