// An edge collapsed where that is safe for the mesh.
//
// pick: one edge. rank: which end may vanish (surgery/feature.h). check: the link condition (every vertex
// that both ends have as neighbour spans a facet with the edge, and no two lines become one), no facet turned
// by more than 60 degrees, no new sliver, no edge too long, nothing that passes through the film. commit:
// collapse_edge, the vertex that stays placed on the smooth film so that volumes are kept.
#pragma once

#include <vector>

#include "film/crossing_grid.h"
#include "scene/scene.h"

namespace lamella::surgery {

enum class ShrinkOutcome {
  done,
  held,      // neither end may vanish along it
  geometry,  // a facet would turn over, or become a sliver
  topology,  // the film would change its topology: the cluster says where
};

struct Shrink {
  ShrinkOutcome outcome = ShrinkOutcome::held;
  film::Vertex kept;                  // where done
  std::vector<film::Vertex> cluster;  // where it is topology that refuses: what would come together
};

// No new edge is longer than `longest`. Without a grid nothing is tested for passing through the film.
Shrink shrink_edge(scene::Scene& scene, film::Edge e, double longest, film::CrossingGrid* grid = nullptr);

}  // namespace lamella::surgery
