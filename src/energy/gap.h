// The gap between a straight edge and the curved wall that it should follow.
#pragma once

#include <vector>

#include "energy/edge_integral.h"
#include "scene/scene.h"

namespace lamella::energy {

// A film that ends on a curved wall gets the gaps between the wall and its straight edges for nothing, and
// would widen them by crowding its vertices elsewhere. An edge on a convex constraint therefore has the
// energy k |S| (|S.n| + |S.m|)/12, S being the edge, n and m the unit normals of the constraint at its ends:
// near the gap's area for k = 1. Fixed edges have none.
struct GapEdge {
  const language::Formula* level = nullptr;
  film::Vertex tail;
  film::Vertex head;
  std::vector<double> tail_attributes = {};  // that the formula reads
  std::vector<double> head_attributes = {};
};

std::vector<GapEdge> gap_edges(const scene::Scene& scene);

// An edge on a convex boundary of one parameter has the energy k |S|^2 (tan a + tan b)/12, a and b being its
// angles with the curve at its ends: near the area between the two, too.
struct BoundaryGapEdge {
  const scene::Boundary* boundary = nullptr;
  film::Vertex tail;
  film::Vertex head;
  double tail_parameter = 0;  // where the search for those at other positions begins
  double head_parameter = 0;
};

std::vector<BoundaryGapEdge> boundary_gap_edges(const scene::Scene& scene);

// For k = 1, with the gradient by both ends, as far as it lies along the boundary.
EdgeGradient boundary_gap_energy(const scene::Scene& scene, const BoundaryGapEdge& edge, const Vec3& tail,
                                 const Vec3& head);

// For k = 1, with the gradient by both ends.
EdgeGradient gap_energy(const GapEdge& edge, const Vec3& tail, const Vec3& head, double time);

// Its second derivatives, by differences of the gradient (which has second derivatives of the level in it
// already): good to about nine digits.
EdgeHessian gap_hessian(const GapEdge& edge, const Vec3& tail, const Vec3& head, double time);
EdgeHessian boundary_gap_hessian(const scene::Scene& scene, const BoundaryGapEdge& edge, const Vec3& tail,
                                 const Vec3& head);

}  // namespace lamella::energy
