// One pass over the triangles for everything that areas and volumes give: energy, gradient, vertex areas,
// volumes, a bound on stiffness.
//
// Triangles are taken four at a time, one in each lane of a vector register (energy/lanes.h), and each
// corner's share is added to its vertex in one aligned line of 64 bytes.
#pragma once

#include <cstdint>
#include <new>
#include <span>
#include <vector>

#include "film/film.h"

namespace lamella::energy {

using film::Vec3;

// The shares that a vertex collects from its triangles. The sweep adds it in two halves of four doubles.
struct alignas(64) VertexLine {
  Vec3 gradient;         // d(sum of tension * area)/d(position)
  double stiffness = 0;  // sum of tension * k over its triangles, k as in `stiffness_bound`
  Vec3 area_vector;      // a third of the vector areas around, each pointing to the region of lower number
  double area = 0;  // a third of the areas around: the mass of the film at the vertex, per unit of density

  VertexLine& operator+=(const VertexLine& other) {
    gradient += other.gradient;
    stiffness += other.stiffness;
    area_vector += other.area_vector;
    area += other.area;
    return *this;
  }
};

// The largest eigenvalue of a triangle's cotangent stiffness matrix, which also bounds its 9x9 area Hessian:
// with S = (sum of squared edges)/(4 area), k = (S + sqrt(S^2 - 3))/2. A vertex whose triangles' tension * k
// sum to s, with mass m, bounds every frequency of the film by omega^2 <= max s/m (Gershgorin's theorem
// applied element by element to the lumped mass), hence an explicit step by dt <= 2/omega.
double stiffness_bound(const Vec3& a, const Vec3& b, const Vec3& c);

struct SweepInput {
  std::span<const Vec3> positions;
  std::span<const std::array<film::Vertex, 3>> triangles;
  std::span<const film::RegionPair> regions;
  std::span<const double> tension;  // one a triangle, or empty for 1 everywhere
  bool has_regions = false;         // some triangle has different regions on its sides
  Vec3 origin;                      // volumes are measured from here; near the film keeps them accurate
};

struct SweepSums {
  double energy = 0;  // sum of tension * area
  double area = 0;
};

// Energy and the volume of each region (volumes[r] for region r; slot 0 collects minus their sum). About 3 ns
// a triangle.
SweepSums sweep_energy(const SweepInput& input, std::span<double> volumes);

// The same, and the vertices' lines, which are overwritten. About 8 ns a triangle.
SweepSums sweep_gradient(const SweepInput& input, std::span<double> volumes, std::span<VertexLine> lines);

}  // namespace lamella::energy
