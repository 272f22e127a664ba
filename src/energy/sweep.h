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

struct SweepSums {
  double energy = 0;  // sum of tension * area
  double area = 0;
};

// How the sweeps over a large film are shared out over threads. Its triangles are cut into parts as they
// lie in memory; a batch of four with a corner that another part has too comes after all parts. The plan
// does not depend on the number of threads, and sums are added in its order, so results are the same to
// the bit for any number. A film that is small, or whose triangles do not lie by place, has no parts: it is
// swept on the calling thread.
class SweepPlan {
 public:
  // Triangles from `first` to before `last`, which is a multiple of a batch or the end of the film.
  struct Range {
    std::uint32_t first = 0;
    std::uint32_t last = 0;
  };

  SweepPlan() = default;
  SweepPlan(std::span<const std::array<film::Vertex, 3>> triangles, std::size_t regions);

  bool empty() const { return parts_.empty(); }
  std::size_t size() const { return parts_.size(); }
  std::span<const Range> inside(std::size_t part) const { return parts_[part]; }
  std::span<const Range> between() const { return between_; }

  // Where parts leave their sums until they are added: the last is for what lies between.
  SweepSums& sums(std::size_t part) { return sums_[part]; }
  std::span<double> volumes(std::size_t part) { return {volumes_.data() + part * regions_, regions_}; }

 private:
  std::vector<std::vector<Range>> parts_;
  std::vector<Range> between_;
  std::size_t regions_ = 0;
  std::vector<SweepSums> sums_;
  std::vector<double> volumes_;
};

struct SweepInput {
  std::span<const Vec3> positions;
  std::span<const std::array<film::Vertex, 3>> triangles;
  std::span<const film::RegionPair> regions;
  std::span<const double> tension;  // one a triangle, or empty for 1 everywhere
  bool has_regions = false;         // some triangle has different regions on its sides
  SweepPlan* plan = nullptr;        // of these triangles, or none
  Vec3 origin;                      // volumes are measured from here; near the film keeps them accurate
};

// Energy and the volume of each region (volumes[r] for region r; slot 0 collects minus their sum). About 3 ns
// a triangle.
SweepSums sweep_energy(const SweepInput& input, std::span<double> volumes);

// The same, and the vertices' lines, which are overwritten. About 8 ns a triangle.
SweepSums sweep_gradient(const SweepInput& input, std::span<double> volumes, std::span<VertexLine> lines);

}  // namespace lamella::energy
