// Bodies that have come apart made several.
#pragma once

#include "scene/scene.h"

namespace lamella::surgery {

// Divides each body whose facets do not hang together along edges: the piece with the first facet keeps the
// body, every other becomes a new body at the end, with a copy of its properties. Returns how many are new.
std::uint32_t divide_bodies(scene::Scene& scene);

}  // namespace lamella::surgery
