// Periodic films for pictures: every bubble whole.
#pragma once

#include "picture/film_copy.h"

namespace lamella::picture {

// A plain film in space. Each body's surface is in one piece (as far as it can be) with its middle in the
// cell that the periods span from the origin; a facet between two bodies is there once for each where they
// lie apart, and then has no body on its other side. Facets without bodies have their own middles in the
// cell.
FilmCopy unwrap(const scene::Scene& scene, const Content& content);

}  // namespace lamella::picture
