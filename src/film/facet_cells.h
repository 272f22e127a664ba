// Which facets lie near one another.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "film/ids.h"
#include "film/vec3.h"

namespace lamella::film {

// Facets by the cells of grids that their middles lie in, each with a box widened by a way that it may go. A
// facet is put anew when it has gone that way; the others stay where they are. There is a grid for each
// octave of sizes, so that large facets among small ones are no more expensive than others.
class FacetCells {
 public:
  // Empties the cells, for so many facets of about this size: half their extent and the way they may go.
  void begin(std::size_t count, double size);
  bool is_empty() const { return entries_.empty(); }
  // Facets have rows up to this.
  void resize(std::size_t count) { entries_.resize(count); }

  // From where a facet is or was, widened. It replaces what was there of it.
  void put(Triangle t, const std::array<Vec3, 3>& corners, double width, const RegionPair& regions);
  // After compaction: facets keep their place under their new row, those without a new row are gone.
  void rename(std::span<const Triangle> rows, std::size_t count);

  // Facets that lie side by side come one after the other.
  void order(std::span<Triangle> facets) const;
  // Whether a facet lies between other regions now.
  bool is_relabelled(Triangle t, const RegionPair& regions) const;
  // Whether its normal, of any length, has turned by more than 20 degrees.
  bool has_turned(Triangle t, const Vec3& normal, const RegionPair& regions) const;
  // Whether the normals of two facets were within 45 degrees.
  bool are_one_way(Triangle a, Triangle b) const { return are_one_way(entries_[a.index], entries_[b.index]); }

  // Calls function(Triangle) once for each other facet whose widened box meets this one's, up to the rounding
  // of floats, but not for facets of one sheet between two regions whose normals are within 45 degrees. They
  // cannot meet: what lies beyond the one is not what lies before the other, and so there is another sheet
  // between them. This stays so while neither has turned.
  template <class Function>
  void for_each_near(Triangle t, Function&& function) const {
    const Entry& own = entries_[t.index];
    const FacetBox box = box_at(own);
    for_each_chunk(own, box, [&](const Chunk& chunk) {
      look_through(chunk, t, own, box, function);
      return true;
    });
  }
  // Whether whole cells around a facet hold nothing but such facets.
  bool is_alone(Triangle t) const {
    bool alone = true;
    for_each_chunk(entries_[t.index], box_at(entries_[t.index]), [&](const Chunk&) { return alone = false; });
    return alone;
  }

 private:
  static constexpr std::uint32_t levels = 16;
  static constexpr std::uint32_t in_chunk = 8;
  struct FacetBox {
    std::array<float, 3> low;
    std::array<float, 3> high;
  };
  struct Entry {
    std::uint32_t chunk = no_index;
    std::uint32_t slot = 0;
    std::array<float, 3> normal{};  // as seen from the lower of the two regions
    RegionPair regions;             // front < behind
  };
  // Some facets of a cell, their boxes in rows that are compared several at a time.
  struct Chunk {
    std::array<std::array<float, in_chunk>, 3> low{};
    std::array<std::array<float, in_chunk>, 3> high{};
    std::array<std::uint32_t, in_chunk> row{};
    std::uint64_t key = 0;
    std::uint32_t count = 0;
    std::uint32_t next = no_index;  // of those in its bucket
    std::array<float, 3> axis{};
    // Of 45 degrees less the angle from the axis to the normal farthest from it: what is so near the axis is
    // within 45 degrees of all.
    float cosine = never;
    RegionPair regions;
  };

  // Chunks of cells that hold what may meet a box, but those of facets of one sheet that agree with its
  // facet's. Goes on as long as the function returns true.
  template <class Function>
  void for_each_chunk(const Entry& own, const FacetBox& box, Function&& function) const {
    const auto goes_on = [&](const Chunk& chunk) {
      const bool agrees = own.regions == chunk.regions && cosine(own.normal, chunk.axis) > chunk.cosine;
      return agrees || function(chunk);
    };
    for (std::uint32_t level = 0; level < levels; ++level) {
      if (in_level_[level] == 0) continue;
      const double reach = reach_ * static_cast<double>(1U << level);
      const double width = cell_of_reach * reach;
      std::array<std::int64_t, 3> low;
      std::array<std::int64_t, 3> high;
      double cells = 1;
      for (std::size_t k = 0; k < 3; ++k) {
        low[k] = cell((box.low[k] - reach) / width);
        high[k] = cell((box.high[k] + reach) / width);
        cells *= static_cast<double>(high[k] - low[k] + 1);
      }
      if (level + 1 == levels || !(cells < in_level_[level])) {
        for (const Chunk& chunk : chunks_) {
          if (chunk.count > 0 && chunk.key % levels == level && !goes_on(chunk)) return;
        }
        continue;
      }
      for (std::int64_t i = low[0]; i <= high[0]; ++i) {
        for (std::int64_t j = low[1]; j <= high[1]; ++j) {
          for (std::int64_t k = low[2]; k <= high[2]; ++k) {
            const std::uint64_t key = key_of(i, j, k, level);
            for (std::uint32_t c = first_[bucket_of(key)]; c != no_index; c = chunks_[c].next) {
              if (chunks_[c].key == key && !goes_on(chunks_[c])) return;
            }
          }
        }
      }
    }
  }

  template <class Function>
  void look_through(const Chunk& chunk, Triangle t, const Entry& own, const FacetBox& box,
                    Function&& function) const {
    std::array<std::int32_t, in_chunk> met;
    for (std::size_t n = 0; n < in_chunk; ++n) {
      met[n] = static_cast<std::int32_t>(chunk.low[0][n] <= box.high[0]) &
               static_cast<std::int32_t>(chunk.high[0][n] >= box.low[0]) &
               static_cast<std::int32_t>(chunk.low[1][n] <= box.high[1]) &
               static_cast<std::int32_t>(chunk.high[1][n] >= box.low[1]) &
               static_cast<std::int32_t>(chunk.low[2][n] <= box.high[2]) &
               static_cast<std::int32_t>(chunk.high[2][n] >= box.low[2]);
    }
    for (std::uint32_t n = 0; n < chunk.count; ++n) {
      if (met[n] == 0 || chunk.row[n] == t.index) continue;
      const Entry& other = entries_[chunk.row[n]];
      const bool is_one_sheet = own.regions == other.regions && own.regions.front != own.regions.behind;
      if (!is_one_sheet || !are_one_way(own, other)) function(Triangle(chunk.row[n]));
    }
  }
  static bool are_one_way(const Entry& a, const Entry& b) {
    return cosine(a.normal, b.normal) > cosine_of_45;
  }
  static float cosine(const std::array<float, 3>& a, const std::array<float, 3>& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  }
  FacetBox box_at(const Entry& entry) const;
  static void set_box(Chunk& chunk, std::uint32_t slot, const FacetBox& box);
  static void add_normal(Chunk& chunk, const Entry& entry);
  void add(std::uint32_t row, std::uint64_t key, const FacetBox& box);
  void take_out(std::uint32_t row);
  std::uint32_t chunk_with_room(std::uint64_t key);

  static constexpr float cosine_of_45 = 0.70711F;
  static constexpr float never = 2;  // the cosine of no angle
  // None is negative. Far out, where cells have no numbers any more, all share the outermost ones.
  static std::int64_t cell(double x) {
    return static_cast<std::int64_t>(std::floor(std::clamp(x, -5e5, 5e5))) + 524288;
  }
  static std::uint64_t key_of(std::int64_t i, std::int64_t j, std::int64_t k, std::uint32_t level) {
    const auto bits = [](std::int64_t n) { return static_cast<std::uint64_t>(n) & 0xfffffU; };
    return (bits(i) << 40U | bits(j) << 20U | bits(k)) * levels + level;
  }
  std::size_t bucket_of(std::uint64_t key) const {
    return key * 0x9e3779b97f4a7c15U >> hash_shift_;  // the upper bits: those depend on all of the key
  }

  static constexpr double cell_of_reach = 1.8;
  double reach_ =
      1;  // of boxes from their middles, in the first level; twice that in the next; any in the last
  std::array<std::uint32_t, levels> in_level_{};
  std::uint32_t hash_shift_ = 63;
  std::vector<std::uint32_t> first_ = {no_index, no_index};  // chunk of each bucket
  std::vector<Chunk> chunks_;
  std::vector<std::uint32_t> free_;  // chunks
  std::vector<Entry> entries_;       // of each facet
};

}  // namespace lamella::film
