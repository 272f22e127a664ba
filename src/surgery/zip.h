// Two films that close on each other along the border where they meet: the border moves on, as a zip.
//
// pick: a vertex on a border of three films. rank: the narrowest wedge between two of them. check: the band
// that joins the far sides of the two fans of facets has less area than the fan that it replaces; nothing
// passes through anything. commit: one fan goes, the band comes, the other fan becomes part of the third
// film.
#pragma once

#include <optional>
#include <vector>

#include "scene/scene.h"
#include "surgery/event.h"

namespace lamella::surgery {

struct Zip {
  std::vector<film::Vertex> touched;
};

// The film is as it was, to the bit, where nothing is returned. No change of topology: regions keep their
// neighbours.
std::optional<Zip> zip(scene::Scene& scene, film::Vertex v, double size);

}  // namespace lamella::surgery
