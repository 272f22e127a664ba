// Where a film passes through itself, or films around a border have changed places.
#pragma once

#include <vector>

#include "film/film.h"

namespace lamella::surgery {

// The corners of facets that pass through one another, and those around borders whose films are out of order;
// what has a vertex in common is one tangle. Empty for a sound film. Not for periodic films.
using Tangle = std::vector<film::Vertex>;
std::vector<Tangle> tangles(const film::Film& film);

// Whether the films around a border do not come in the order that the complex says.
bool is_out_of_order(const film::Film& film, film::Edge e);

// Of two facets; those that they share come twice.
Tangle corners_of(const film::Film& film, film::Triangle a, film::Triangle b);

// The vertices of a tangle and those so many edges away, each once.
Tangle grown(const film::Film& film, const Tangle& tangle, int rings);

// Tangles that have come to overlap made one.
std::vector<Tangle> united(const film::Film& film, const std::vector<Tangle>& tangles);

}  // namespace lamella::surgery
