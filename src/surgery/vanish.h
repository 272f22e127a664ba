// What has become too small for its mesh: bubbles, and scraps of film that hang on nothing (T2).
//
// pick: a region, or a piece of film that nothing holds, of less volume (or area, where it encloses none)
// than a small part of its mesh's size to that power, all within one size of its middle. rank: smallest
// first. check: no vertex is held; where films lead away, what is to join them passes through nothing.
// commit: a piece is taken out; a region shrinks to a point, which is resolved as any other
// (surgery/contract.h).
#pragma once

#include <vector>

#include "scene/scene.h"
#include "surgery/event.h"

namespace lamella::surgery {

struct Vanished {
  std::vector<Event> events;
  std::vector<film::Vertex> touched;  // some removed since
};

// Whether there is anything of the sort.
bool has_small_parts(const scene::Scene& scene);

// The film is as it was, to the bit, where no event is returned. Bodies are told apart by
// surgery/regions.h afterwards: a body without films is absent, whatever its target was.
Vanished vanish_small_parts(scene::Scene& scene);

}  // namespace lamella::surgery
