// Edges with more than three films, and points that are none of the three that soap films have, resolved.
#pragma once

#include <span>
#include <vector>

#include "scene/scene.h"
#include "surgery/event.h"

namespace lamella::surgery {

// The mean length of the edges at a vertex: 0 where there are none.
double size_at(const film::Film& film, film::Vertex v);

// Vertices that nothing holds and whose link is no disc, rim, triple or tetrahedral point.
std::vector<film::Vertex> illegal_vertices(const scene::Scene& scene);

// Edges of more than three films.
std::vector<film::Edge> crowded_edges(const film::Film& film);

struct PopReport {
  long edges = 0;     // with more than three films before, and no more
  long vertices = 0;  // resolved
  std::vector<Event> events;
};

// Resolves vertices by the rearrangement that lowers the energy most, and what that leaves around them in
// turn: where an edge of many films is drawn apart at one point, its neighbours follow. Each start may lead
// to so many further ones as the chain is long, and no more. `gain`: see ContractOptions.
PopReport pop_vertices(scene::Scene& scene, std::span<const film::Vertex> vertices, double gain = 1e-6);

// The same for edges of more than three films. One between vertices that are held is divided first.
PopReport pop_edges(scene::Scene& scene, std::span<const film::Edge> edges, double gain = 1e-6);

}  // namespace lamella::surgery
