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

// Work on the rows of vertices that goes along with a sweep, while they are in cache: before the first of a
// vertex's triangles is met, and after the last. Rows are done in groups, each row once, groups of different
// parts side by side; groups and their order do not depend on the number of threads.
class RowWork {
 public:
  RowWork() = default;
  RowWork(const RowWork&) = delete;
  RowWork& operator=(const RowWork&) = delete;
  virtual ~RowWork() = default;
  // Rows from `first` to before `last`. The positions of the sweep may be written here, and the lines of the
  // sweep before read.
  virtual void before(std::size_t part, std::size_t first, std::size_t last) = 0;
  virtual void after(std::size_t part, std::size_t first, std::size_t last) = 0;
};

// How the sweeps over a film are shared out over threads, and into stages that leave what they touch in
// cache. The triangles of a large film are cut into parts as they lie in memory; a batch of four with a
// corner that another part has too comes after all parts. The plan does not depend on the number of threads,
// and sums are added in its order, so results are the same to the bit for any number. A film that is small,
// or whose triangles do not lie by place, is one part.
class SweepPlan {
 public:
  // Rows, or triangles: these from a multiple of a batch to another or the end of the film.
  struct Range {
    std::uint32_t first = 0;
    std::uint32_t last = 0;
  };
  // Some triangles of a part, the rows that they are the first to touch, and those that they are the last to.
  struct Stage {
    Range triangles;
    std::span<const Range> fresh;
    std::span<const Range> done;
  };

  SweepPlan() = default;
  SweepPlan(SweepPlan&&) noexcept = default;  // stages point into the plan
  SweepPlan& operator=(SweepPlan&&) noexcept = default;
  // For films of so many rows of vertices.
  SweepPlan(std::span<const std::array<film::Vertex, 3>> triangles, std::size_t rows, std::size_t regions);

  std::size_t size() const { return stages_.size(); }
  std::span<const Stage> stages(std::size_t part) const { return stages_[part]; }
  std::span<const Range> between() const { return between_; }
  // Rows of what lies between parts, and of vertices without triangles. Row 0 is in no list.
  std::span<const Range> shared_rows() const { return shared_rows_; }

  // Where parts leave their sums until they are added: the last is for what lies between.
  SweepSums& sums(std::size_t part) { return sums_[part]; }
  std::span<double> volumes(std::size_t part) { return {volumes_.data() + part * regions_, regions_}; }

 private:
  using Parts = std::vector<std::vector<Range>>;
  Parts cut(std::span<const std::array<film::Vertex, 3>> triangles, std::size_t rows);
  void plan_stages(const Parts& parts, std::span<const std::array<film::Vertex, 3>> triangles,
                   std::size_t rows);

  std::vector<std::vector<Stage>> stages_;
  std::vector<std::vector<Range>> ranges_;  // that stages point into
  std::vector<Range> between_;
  std::vector<Range> shared_rows_;
  std::size_t regions_ = 0;
  std::vector<SweepSums> sums_;
  std::vector<double> volumes_;
};

// A corner of a triangle at a vertex where more than two regions meet: where its share of the area vector is
// added (for the region of higher number) and taken away (for the lower).
struct BorderCorner {
  static constexpr std::uint32_t none = 0xffffffffU;
  std::uint32_t triangle = 0;
  std::uint32_t higher = none;  // slots
  std::uint32_t lower = none;
};

struct alignas(32) VolumeSlot {
  Vec3 gradient;
  double spare = 0;  // anything: four numbers are added at once
};

struct SweepInput {
  std::span<const Vec3> positions;
  std::span<const std::array<film::Vertex, 3>> triangles;
  std::span<const film::RegionPair> regions;
  std::span<const double> tension;  // one a triangle, or empty for 1 everywhere
  bool has_regions = false;         // some triangle has different regions on its sides
  SweepPlan* plan = nullptr;        // of these triangles, or none
  Vec3 origin;                      // volumes are measured from here; near the film keeps them accurate
  // Gradients of volumes where regions meet, which sweep_gradient overwrites: corners in the triangles'
  // order.
  std::span<const BorderCorner> corners;
  std::span<VolumeSlot> slots;
};

// Energy and the volume of each region (volumes[r] for region r; slot 0 collects minus their sum). About 3 ns
// a triangle.
SweepSums sweep_energy(const SweepInput& input, std::span<double> volumes);

// The same, and the vertices' lines, which are overwritten. About 8 ns a triangle. `work` needs a plan;
// before it makes the first row, whose place is the origin, is up to the caller.
SweepSums sweep_gradient(const SweepInput& input, std::span<double> volumes, std::span<VertexLine> lines,
                         RowWork* work = nullptr);

// The work that comes after a sweep, of all rows in the same groups.
void work_after_sweep(const SweepPlan& plan, RowWork& work);

}  // namespace lamella::energy
