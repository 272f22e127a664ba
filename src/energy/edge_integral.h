// Vector fields integrated along straight edges: what constraints add to energies and volumes.
#pragma once

#include <vector>

#include "film/mat3.h"
#include "scene/scene.h"

namespace lamella::energy {

using film::Vec3;

struct EdgeGradient {
  double value = 0;
  Vec3 from;
  Vec3 to;
};

// Second derivatives by both ends: a block of the head is d2/d(to)d(to), `from_to` is d2/d(from)d(to).
struct EdgeHessian {
  film::Mat3 from_from;
  film::Mat3 to_to;
  film::Mat3 from_to;
};

// An edge that a field is integrated along, so many times (negative: against its direction). Or, in films of
// one dimension, a function of which the value at the tail is taken from that at the head.
struct FieldEdge {
  const scene::EdgeIntegrand* field = nullptr;
  film::Vertex from;
  film::Vertex to;
  double times = 1;
  film::Region region;  // of a content: the region whose volume gets it
  // The edge's attributes that the field's components read, one component after the other.
  std::vector<double> attributes = {};
  // In a periodic film, what brings the ends to where the edge lies.
  Vec3 shift_from = {};
  Vec3 shift_to = {};
  // Of a function at the ends (the field's first component): at which.
  bool at_from = false;
  bool at_to = false;
};

// So many times the integral of a field along the straight edge, by Gauss's rule with as many points as
// integrate polynomials of degree `order` exactly.
double edge_integral(const FieldEdge& edge, std::span<const Vec3> positions, double time, int order);
EdgeGradient edge_integral_gradient(const FieldEdge& edge, std::span<const Vec3> positions, double time,
                                    int order);
EdgeHessian edge_integral_hessian(const FieldEdge& edge, std::span<const Vec3> positions, double time,
                                  int order);

// The edges with constraint energies, and those with contents, a row for each region that they bound: a
// content is added to a body behind a facet (normal outward) whose side runs along the edge, and taken from
// the one in front; contents of boundaries (not of level sets) with the opposite sign. Fields point into the
// scene's constraints, which must live on and be bound.
std::vector<FieldEdge> energy_edges(const scene::Scene& scene);
std::vector<FieldEdge> content_edges(const scene::Scene& scene);

}  // namespace lamella::energy
