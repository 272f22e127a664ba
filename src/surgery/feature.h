// What a vertex belongs to, and hence where it may go.
#pragma once

#include "scene/scene.h"

namespace lamella::surgery {

// A vertex may vanish onto one of at least its rank, along the feature that it belongs to.
enum class Rank {
  sheet,   // inside a film
  rim,     // on the free edge of a film
  border,  // on a Plateau border
  wire,    // inside a wire: a line of fixed edges, or edges on a boundary or constraint
  corner,  // where borders or wires meet or end
  fixed,
};

Rank rank_of(const scene::Scene& scene, film::Vertex v);

// Whether an edge is part of a line: not inside a film, or held.
bool is_line(const scene::Scene& scene, film::Edge e);

// The normal of the film around a vertex inside a sheet, unit length, turned to agree with a direction.
film::Vec3 normal_at(const film::Film& film, film::Vertex v, const film::Vec3& toward);

// A point between the ends of an edge on the smooth film, or smooth line, that the mesh stands for: the
// middle of a cubic with the tangents at both ends. The plain middle where an end is a corner.
film::Vec3 smooth_middle(const scene::Scene& scene, film::Edge e);

}  // namespace lamella::surgery
