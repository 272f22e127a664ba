// How far the middles of edges lie from the film that the facets stand for.
#pragma once

#include <vector>

#include "film/film.h"

namespace lamella::evolution {

// For each edge the way from its middle to the smooth film through its ends, to third order in its length:
// inside films by the normals at the ends, on borders between films by the neighbouring border points. Zero
// on wires and rims, whose curves are known otherwise, and where the mesh is too coarse to tell. For a film
// near its equilibrium: a refined mesh then begins several times as near to its own.
std::vector<film::Vec3> bulges(const film::Film& film);

}  // namespace lamella::evolution
