// Two sheets that touch made one: a common film where they face each other, bounded by a border at which it
// meets a strip to the one and the rest of the other.
//
// pick: a vertex and a facet near it. rank: the patch P of the vertex' sheet that lies close to the other
// sheet, else the facets around the vertex alone; on the other sheet Q, the stars of all vertices over P, so
// that its rim lies a ring farther out. check: both are discs without borders, wires or fixed vertices; both
// face the same region; the strip from rim to rim has less area than Q; nothing passes through anything.
// commit: Q goes, the strip comes, P parts what lay beyond the two sheets. If that is one closed region on
// both sides, P goes, too.
#pragma once

#include <optional>

#include "scene/scene.h"
#include "surgery/event.h"
#include "surgery/proximity.h"

namespace lamella::surgery {

struct Merge {
  Event event;
  std::vector<film::Vertex> touched;
};

// The film is as it was, to the bit, where nothing is returned.
std::optional<Merge> merge(scene::Scene& scene, const NearPair& pair, double size);

}  // namespace lamella::surgery
