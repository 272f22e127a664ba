// An edge shrunk to a point, with the facets around it.
#pragma once

#include <optional>
#include <vector>

#include "scene/scene.h"

namespace lamella::surgery {

enum class Collapse : std::uint8_t {
  done,
  held,     // the edge is fixed, or neither end may move along it
  blocked,  // two edges would join the same vertices, or two facets the same three
};

// Makes the ends of an edge one vertex, as Surface Evolver does: the facets around the edge vanish, and in
// each of them the two other sides become one, that at the edge's head unless only the other is fixed or held
// by constraints. An end that is fixed, or held otherwise than the edge, stays where it is and keeps its
// number; else the tail stays, halfway. Regions stay as they were, and so does the order of films around
// borders.
//
// Where the ends have a common neighbour beyond a third vertex inside one facet (three facets around a
// vertex in place of one), that vertex is removed first.
Collapse collapse_edge(scene::Scene& scene, film::Edge edge);

// Collapses one side of a facet, the shortest that can be.
Collapse collapse_facet(scene::Scene& scene, film::Triangle facet);

}  // namespace lamella::surgery
