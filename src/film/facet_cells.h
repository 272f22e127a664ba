// Which facets lie near a box.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "film/box_tree.h"
#include "film/film.h"

namespace lamella::film {

// Facets by the cells of a grid that their middles lie in.
class FacetCells {
 public:
  // A facet of a sheet between two regions, as seen from the lower one. Facets of one sheet whose normals
  // agree cannot meet: what lies beyond the one is not what lies before the other, and so there is another
  // sheet between them.
  struct Sheet {
    RegionPair regions;  // front < behind, or alike where it is no such facet
    bool flipped = false;
  };
  static Sheet sheet_of(const RegionPair& regions);

  // From where each facet is, or was; its box is widened by a width of its own. n, without allocation once it
  // has its size.
  void make(std::span<const std::array<Vec3, 3>> facets, std::span<const double> widths,
            std::span<const RegionPair> regions);

  // Calls function(i, Triangle) once for each of some facets, with boxes of theirs, and each facet whose
  // widened box meets it, up to the rounding of floats. Not for facets of the same sheet whose normals are
  // within 45 degrees, where a whole cell and those that ask are so. Boxes that lie in one tower of cells are
  // asked for together.
  template <class Function>
  void for_each_near(std::span<const Triangle> facets, std::span<const Box> boxes, Function&& function) {
    sort_by_tower(boxes);
    for (std::size_t begin = 0, end = 0; begin < asked_.size(); begin = end) {
      Box around = boxes[asked_[begin].row];
      Cone cone;
      for (end = begin; end < asked_.size() && is_one_tower(begin, end); ++end)
        around = joined(around, boxes[asked_[end].row]);
      for (std::size_t n = begin; n < end; ++n) add_to(cone, facets[asked_[n].row], n == begin);
      cone.axis = unit(cone.axis);
      for (std::size_t n = begin; n < end; ++n) widen(cone, facets[asked_[n].row]);
      cone.angle = angle_of(cone.cosine);
      gather(around, cone);
      for (std::size_t n = begin; n < end; ++n) {
        const std::size_t count = pick(rounded_outward(boxes[asked_[n].row]));
        for (std::size_t k = 0; k < count; ++k) function(asked_[n].row, candidates_.facet[picked_[k]]);
      }
    }
  }

 private:
  static constexpr double most_cells = 4000;
  static constexpr std::int64_t tower = 4;  // cells one above the other that lie in one bucket

  struct NearBox {
    std::array<float, 3> low;
    std::array<float, 3> high;
  };
  struct Entry {
    std::uint64_t key = 0;
    Triangle facet;
  };
  struct Asked {
    std::uint64_t key = 0;
    std::uint32_t row = 0;
  };
  // Facets near a tower, and their boxes in rows that are compared several at a time.
  struct Candidates {
    std::vector<Triangle> facet;
    std::array<std::vector<float>, 3> low;
    std::array<std::vector<float>, 3> high;
  };
  // The normals of facets of one sheet.
  struct Cone {
    RegionPair regions;  // alike where they are of more than one, or of none
    Vec3 axis;
    double cosine = 1;  // of the angle to the farthest from it
    double angle = 0;   // that, when all are known
  };
  void add_to(Cone& cone, Triangle t, bool first) const;
  void widen(Cone& cone, Triangle t) const {
    cone.cosine = std::min(cone.cosine, dot(cone.axis, normals_[t.index]));
  }
  static double angle_of(double cosine) { return std::acos(std::clamp(cosine, -1.0, 1.0)); }
  static bool are_one_sheet(const Cone& a, const Cone& b);
  void sort_by_tower(std::span<const Box> boxes);
  bool is_one_tower(std::size_t a, std::size_t b) const {
    return asked_[a].key / tower == asked_[b].key / tower;
  }
  // Fills the candidates with what may meet a box, and what is in the cone.
  void gather(const Box& box, const Cone& cone);
  void add_candidate(Triangle t);
  // The rows of candidates that meet a box go to picked_; returns how many.
  std::size_t pick(const NearBox& box);
  static NearBox rounded_outward(const Box& box, double margin = 0);
  // None is negative. (1048576 is a multiple of the height of a tower.)
  static std::int64_t cell(double x) {
    return static_cast<std::int64_t>(std::floor(std::clamp(x, -1e6, 1e6))) + 1048576;
  }
  // 21 bits each: cells one above the other have keys that follow one another.
  static std::uint64_t key_of(std::int64_t i, std::int64_t j, std::int64_t k) {
    const auto bits = [](std::int64_t n) { return static_cast<std::uint64_t>(n) & 0x1fffffU; };
    return bits(i) << 42U | bits(j) << 21U | bits(k);
  }
  // One for all cells of a tower.
  std::size_t bucket_of(std::uint64_t key) const {
    const std::uint64_t hash = key / tower * 0x9e3779b97f4a7c15U;
    return (hash ^ (hash >> 32U)) & (first_.size() - 2);
  }

  double width_ = 1;
  double reach_ = 0;                  // of widened boxes from their middles, of those that are not wide
  std::vector<std::uint64_t> keys_;   // of each facet
  std::vector<NearBox> near_boxes_;   // of each facet, widened
  std::vector<std::uint32_t> first_;  // entry of each bucket, and one more
  std::vector<Entry> entries_;
  std::vector<Triangle> wide_;
  std::vector<RegionPair> regions_;  // of each facet's sheet
  std::vector<Vec3> normals_;        // as seen from its lower region
  std::vector<Cone> cones_;          // of each bucket
  std::vector<Asked> asked_;
  Candidates candidates_;
  std::vector<std::int32_t> met_;
  std::vector<std::uint32_t> picked_;
};

}  // namespace lamella::film
