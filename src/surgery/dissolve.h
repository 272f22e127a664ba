// Elements taken out of the film, the gap left open.
#pragma once

#include "scene/scene.h"

namespace lamella::surgery {

// Each removes the element if nothing else is made of it, and tells whether it did: a vertex without edges,
// an edge without facets, a facet that does not part two bodies.
bool dissolve(scene::Scene& scene, film::Vertex v);
bool dissolve(scene::Scene& scene, film::Edge e);
bool dissolve(scene::Scene& scene, film::Triangle t);
// A body: its facets stay.
bool dissolve(scene::Scene& scene, film::Region body);

}  // namespace lamella::surgery
