// The gap between a straight edge and the curved wall that it should follow.
#pragma once

#include <vector>

#include "energy/edge_integral.h"
#include "scene/scene.h"

namespace lamella::energy {

// A film that ends on a curved wall gets the gaps between the wall and its straight edges for nothing, and
// would widen them by crowding its vertices elsewhere. An edge on a convex constraint therefore has the
// energy k |S x Q| / 6, S being the edge and Q its projection on the tangent plane at its tail: near the
// gap's area for k = 1.
struct GapEdge {
  const language::Formula* level = nullptr;
  film::Vertex tail;
  film::Vertex head;
};

std::vector<GapEdge> gap_edges(const scene::Scene& scene);

// For k = 1, with the gradient by both ends.
EdgeGradient gap_energy(const language::Formula& level, const Vec3& tail, const Vec3& head, double time);

// Its second derivatives, by differences of the gradient (which has second derivatives of the level in it
// already): good to about nine digits.
EdgeHessian gap_hessian(const language::Formula& level, const Vec3& tail, const Vec3& head, double time);

}  // namespace lamella::energy
