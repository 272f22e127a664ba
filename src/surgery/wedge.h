// The angles between films around an edge.
#pragma once

#include <functional>
#include <span>

#include "film/film.h"

namespace lamella::surgery {

// The way from a border edge into the film of a side, across the edge; unit length.
film::Vec3 across(const film::Film& film, film::Side s);

// The narrowest angle between neighbouring films at an edge of three or more (radians); pi where there are
// fewer.
double narrowest_wedge(const film::Film& film, film::Edge e);

// Whether some facets have an edge of three or more films with a wedge narrower than an angle: what moves
// them could make films cross there.
bool has_narrow_wedge(const film::Film& film, std::span<const film::Triangle> facets, double angle);

// The films around an edge, by directions in their stored order: whether they turn once around it, each by
// `least` at the least.
bool turns_once(const film::Vec3& axis, std::span<const film::Vec3> directions, double least);

}  // namespace lamella::surgery
