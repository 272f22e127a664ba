// Which facets lie near a box, while a film moves a little.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "film/box_tree.h"
#include "film/film.h"

namespace lamella::film {

// The facets of a film by the cells of a grid that their middles lie in. They may move by a part of a cell
// before the grid must be made anew: n, without allocation once it has its size.
class FacetCells {
 public:
  // Whether what it holds may be asked about a film as it is now.
  bool holds(const Film& film) const;
  // Facets are widened by `margin` of their longest side.
  void make(const Film& film, double margin);

  // Calls function(Triangle) once for each facet whose box, widened by the margin, may meet another: not all
  // do.
  template <class Function>
  void for_each_near(const Box& box, Function&& function) const {
    for (const Triangle t : wide_) function(t);
    const double reach = reach_ + drift * width_;
    const Vec3 low = (1 / width_) * (box.low - Vec3{reach, reach, reach});
    const Vec3 high = (1 / width_) * (box.high + Vec3{reach, reach, reach});
    const double cells = (high.x - low.x + 1) * (high.y - low.y + 1) * (high.z - low.z + 1);
    if (!(cells < most_cells)) {
      for (const Entry& entry : entries_) function(entry.facet);
      return;
    }
    for (std::int64_t i = cell(low.x); i <= cell(high.x); ++i) {
      for (std::int64_t j = cell(low.y); j <= cell(high.y); ++j) {
        for (std::int64_t k = cell(low.z); k <= cell(high.z); ++k) {
          const std::uint64_t key = key_of(i, j, k);
          const std::size_t bucket = bucket_of(key);
          for (std::uint32_t n = first_[bucket]; n < first_[bucket + 1]; ++n) {
            if (entries_[n].key == key) function(entries_[n].facet);
          }
        }
      }
    }
  }

 private:
  static constexpr double drift = 0.25;  // of a cell, before it is made anew
  static constexpr double most_cells = 4000;

  struct Entry {
    std::uint64_t key = 0;
    Triangle facet;
  };
  static std::int64_t cell(double x) {
    return static_cast<std::int64_t>(std::floor(std::clamp(x, -1e6, 1e6)));
  }
  // 21 bits each.
  static std::uint64_t key_of(std::int64_t i, std::int64_t j, std::int64_t k) {
    const auto bits = [](std::int64_t n) { return static_cast<std::uint64_t>(n + 1048576) & 0x1fffffU; };
    return bits(i) << 42U | bits(j) << 21U | bits(k);
  }
  std::size_t bucket_of(std::uint64_t key) const {
    const std::uint64_t hash = key * 0x9e3779b97f4a7c15U;
    return (hash ^ (hash >> 32U)) & (first_.size() - 2);
  }

  double width_ = 1;
  double reach_ = 0;  // of widened boxes from their middles, of those that are not wide
  std::vector<Vec3> made_at_;
  std::vector<std::uint64_t> keys_;   // of each facet
  std::vector<std::uint32_t> first_;  // entry of each bucket, and one more
  std::vector<Entry> entries_;
  std::vector<Triangle> wide_;
};

}  // namespace lamella::film
