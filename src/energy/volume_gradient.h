// The gradients of region volumes, as sparse as they are.
//
// A vertex inside a film parts two regions, and the sweep has already summed its area vector: that vector is
// the gradient of one region's volume and minus that of the other. Only vertices on borders and rims hold a
// list of their own, refreshed by a pass over the few triangles that touch them.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "energy/edge_integral.h"
#include "energy/lanes.h"
#include "energy/open_rim.h"
#include "energy/sweep.h"
#include "energy/vertex_constraints.h"
#include "film/film.h"

namespace lamella::energy {

// Which entries the Gram matrix of the gradients can have: rows i >= j, sorted, each once.
struct GramEntry {
  int row = 0;
  int column = 0;
  friend constexpr auto operator<=>(const GramEntry&, const GramEntry&) = default;
};

// A constraint on something else than a volume: its row, and the vertices that it depends on.
struct FixedRow {
  int row = 0;
  std::vector<std::uint32_t> vertices;
};

class VolumeGradient {
 public:
  VolumeGradient() = default;  // no rows
  // row_of_region[r] is the row of region r among those wanted, or -1. The ends of edges with
  // contents, whose integrals to degree `order` count too, and the vertices of `fixed` get lists of their
  // own. Rows count regions and `fixed`.
  VolumeGradient(const film::Film& film, std::span<const int> row_of_region, int rows,
                 std::span<const FieldEdge> contents, int order, std::span<const FixedRow> fixed = {});

  int rows() const { return rows_; }
  const std::vector<GramEntry>& pattern() const { return pattern_; }

  // What a sweep fills at borders (SweepInput): the gradients stay those of before until `finish`.
  std::span<const BorderCorner> corners() const { return corners_; }
  std::span<VolumeSlot> next_slots() { return next_slots_; }
  // After such a sweep. `lines` are its lines; the inner vertices' gradients are read from them in the calls
  // below, so they must live on unchanged.
  void finish(const SweepInput& input, std::span<const VertexLine> lines, OpenVolume convention, double time);
  // The same after a sweep that has filled nothing here.
  void update(const SweepInput& input, std::span<const VertexLine> lines, OpenVolume convention, double time);
  // After that: the gradient of a fixed row, by vertex.
  void set_fixed(int row, std::span<const Vec3> gradient);
  // Takes out of the gradients what constraints forbid; after `update`, and again when directions were
  // renewed.
  void restrict(const VertexConstraints& constraints);

  // G w G^T for vertex weights w (an inverse mass; 0 holds a vertex still): one value for each pattern entry.
  void gram(std::span<const double> weights, std::span<double> values) const;
  // result[i] = sum over vertices of weight * gradient_i . field.
  void dot(std::span<const double> weights, std::span<const Vec3> field, std::span<double> result) const;
  // Holds the multipliers of the rows for calls of `pull`, until the next call.
  void set_multipliers(std::span<const double> multipliers);
  // What descent and motion ask of the vertices: G w G^T, for two fields a and b the sums over vertices of
  // gradient_i . a and gradient_i . b, and the largest of a number. Of all: energy/volume_products.h.
  struct RunSum {
    std::uint32_t pair = 0;
    double square = 0;
    double first = 0;
    double second = 0;
  };
  struct RunSums {
    std::vector<RunSum> runs;
    double largest = 0;
    void clear() {
      runs.clear();
      largest = 0;
    }
  };
  struct Products {
    std::vector<double> gram;
    std::vector<double> first;
    std::vector<double> second;
    double largest = 0;
    std::vector<RunSums> parts;  // that they are summed from
  };
  struct Fields {
    Lane a;  // the fourth numbers may be anything
    Lane b;
    double number = 0;
  };
  // Adds the vertices from `begin` to before `end` where they lie inside films, and the number of all.
  // `fields(v)` returns Fields.
  template <class Function>
  void add_rows(std::size_t begin, std::size_t end, std::span<const double> weights, const Function& fields,
                RunSums& sums) const;
  // After all rows have been added to `products.parts`: sums them, and adds the vertices on borders.
  template <class Function>
  void collect(std::span<const double> weights, const Function& fields, Products& products) const;
  // The matrix in the pattern's order times a vector.
  void multiply_gram(std::span<const double> values, std::span<const double> vector,
                     std::span<double> result) const;
  // A second set of multipliers beside the first, and the pulls of both at one vertex.
  void set_multipliers(std::span<const double> first, std::span<const double> second);
  // Both pulls from row `begin` to before `end`: calls inner(first, last, factor, factor) for rows whose
  // pulls are these factors times `inner_vector`, and border(row, pull, pull).
  template <class Inner, class Border>
  void for_each_pull(std::size_t begin, std::size_t end, const Inner& inner, const Border& border) const {
    for_each_run(
        begin, end,
        [&](std::size_t first, std::size_t last, std::uint32_t pair) {
          const bool none_pulls = pair == none;
          inner(first, last, none_pulls ? 0 : pair_factor_[pair], none_pulls ? 0 : second_factor_[pair]);
        },
        [&](std::size_t row, const auto& at) {
          const auto [first, second] = border_pulls(at);
          border(row, first, second);
        });
  }
  // The area vector of a vertex inside a film, without what constraints forbid.
  Lane inner_vector(std::size_t vertex) const {
    return restricted_.empty() ? lane_at(&lines_[vertex].area_vector.x) : load(restricted_, vertex);
  }
  // sum_i multipliers[i] gradient_i at one vertex: the force of the pressures there.
  Vec3 pull(std::size_t vertex) const {
    const std::uint32_t place = place_of_vertex_[vertex];
    if (place == none) return {};
    if (place < pairs_.size()) return pair_factor_[place] * area_vector(vertex);
    return border_pull(borders_[place - pairs_.size()]);
  }

  // The same at a vertex with a list of its own, before constraints took their part out.
  Vec3 unrestricted_pull(std::size_t vertex) const;

  // Calls function(vertex row, row i) wherever row i may be nonzero: the pattern, known before any update.
  template <class Function>
  void for_each_entry(Function&& function) const {
    for (std::uint32_t v = 0; v < place_of_vertex_.size(); ++v) {
      if (place_of_vertex_[v] >= pairs_.size()) continue;
      const Pair& pair = pairs_[place_of_vertex_[v]];
      if (pair.high >= 0) function(v, pair.high);
      if (pair.low >= 0) function(v, pair.low);
    }
    for (const BorderVertex& border : borders_) {
      for (std::uint32_t s = border.first; s < border.last; ++s) function(border.vertex, slot_rows_[s]);
    }
  }

  // Calls function(vertex row, row i, gradient) for every nonzero row of every vertex, after an update.
  template <class Function>
  void for_each(Function&& function) const {
    for (std::uint32_t v = 0; v < place_of_vertex_.size(); ++v) {
      if (place_of_vertex_[v] >= pairs_.size()) continue;
      const Pair& pair = pairs_[place_of_vertex_[v]];
      if (pair.high >= 0) function(v, pair.high, area_vector(v));
      if (pair.low >= 0) function(v, pair.low, -area_vector(v));
    }
    for (const BorderVertex& border : borders_) {
      for (std::uint32_t s = border.first; s < border.last; ++s)
        function(border.vertex, slot_rows_[s], slots_[s].gradient);
    }
  }

 private:
  static constexpr std::uint32_t none = 0xffffffffU;

  // Rows of the two regions that a film parts, the one of higher number first; -1 where not wanted.
  struct Pair {
    int high = -1;
    int low = -1;
    int entry_high = -1;  // where (high,high), (low,low), (high,low) stand in the pattern
    int entry_low = -1;
    int entry_mixed = -1;
  };
  struct BorderVertex {
    std::uint32_t vertex = 0;
    std::uint32_t first = 0;  // its slots
    std::uint32_t last = 0;
    std::uint32_t first_entry = 0;  // where its pairs of slots (s >= t, row by row) stand in the pattern
  };
  struct Rim {
    RimEdge edge;
    std::uint32_t from = none;  // slots
    std::uint32_t to = none;
  };
  struct Content {
    FieldEdge edge;
    std::uint32_t from = none;  // slots
    std::uint32_t to = none;
  };

  // Of a vertex inside one film, without what constraints forbid.
  const Vec3& area_vector(std::size_t vertex) const {
    return restricted_.empty() ? lines_[vertex].area_vector : restricted_[vertex];
  }
  Vec3 border_pull(const BorderVertex& border) const;
  std::pair<Vec3, Vec3> border_pulls(const BorderVertex& border) const;
  void factor_pairs(std::span<const double> multipliers, std::vector<double>& factors) const;
  void add_run(const RunSum& run, Products& products) const;
  void add_border(const BorderVertex& border, double weight, const Vec3& a, const Vec3& b,
                  Products& products) const;
  // Calls inner(first, last, pair or none) for rows that follow each other inside the same film or in none,
  // and border(row, border) for those on borders.
  template <class Inner, class Border>
  void for_each_run(std::size_t begin, std::size_t end, const Inner& inner, const Border& border) const {
    if (rows_ == 0) {
      inner(begin, end, none);
      return;
    }
    for (std::size_t v = begin; v < end;) {
      const std::uint32_t place = place_of_vertex_[v];
      if (place != none && place >= pairs_.size()) {
        border(v, borders_[place - pairs_.size()]);
        ++v;
        continue;
      }
      std::size_t last = v + 1;
      while (last < end && place_of_vertex_[last] == place) ++last;
      inner(v, last, place);
      v = last;
    }
  }
  void find_borders(const film::Film& film, std::span<const int> row_of_region,
                    std::span<const FieldEdge> contents, std::span<const FixedRow> fixed);
  void build_pattern();

  int rows_ = 0;
  // A vertex inside a film: its pair. On a border: the number of pairs plus its border. Else none.
  std::vector<std::uint32_t> place_of_vertex_;
  std::vector<Pair> pairs_;
  std::vector<BorderVertex> borders_;
  std::vector<VolumeSlot> slots_;
  std::vector<VolumeSlot> next_slots_;
  std::vector<int> slot_rows_;
  std::vector<BorderCorner> corners_;
  std::vector<Rim> rims_;
  std::vector<Content> contents_;
  int order_ = 3;
  std::vector<GramEntry> pattern_;
  std::vector<int> border_entries_;
  std::vector<double> pair_factor_;  // multiplier of the high row minus that of the low one
  std::vector<double> multipliers_;
  std::vector<double> second_factor_;
  std::vector<double> second_multipliers_;
  std::vector<Vec3> unrestricted_;  // of the slots; empty until constraints take something out
  std::span<const VertexLine> lines_;
  std::vector<Vec3> restricted_;  // area vectors of inner vertices; empty in a scene without constraints
};

template <class Function>
void VolumeGradient::add_rows(std::size_t begin, std::size_t end, std::span<const double> weights,
                              const Function& fields, RunSums& sums) const {
  const auto inner = [&](std::size_t first, std::size_t last, std::uint32_t pair) {
    if (pair == none) {  // as everywhere in a scene without volumes, which has no area vectors either
      for (std::size_t v = first; v < last; ++v) sums.largest = std::max(sums.largest, fields(v).number);
      return;
    }
    Lane square{};
    Lane along_a{};
    Lane along_b{};
    for (std::size_t v = first; v < last; ++v) {
      const auto [a, b, number] = fields(v);
      sums.largest = std::max(sums.largest, number);
      const Lane vector = inner_vector(v);
      square += weights[v] * (vector * vector);
      along_a += vector * a;
      along_b += vector * b;
    }
    sums.runs.push_back({pair, sum_of_3(square), sum_of_3(along_a), sum_of_3(along_b)});
  };
  for_each_run(begin, end, inner, [&](std::size_t v, const BorderVertex&) {
    sums.largest = std::max(sums.largest, fields(v).number);
  });
}

template <class Function>
void VolumeGradient::collect(std::span<const double> weights, const Function& fields,
                             Products& products) const {
  products.gram.assign(pattern_.size(), 0.0);
  products.first.assign(static_cast<std::size_t>(rows_), 0.0);
  products.second.assign(static_cast<std::size_t>(rows_), 0.0);
  products.largest = 0;
  for (const RunSums& part : products.parts) {
    products.largest = std::max(products.largest, part.largest);
    for (const RunSum& run : part.runs) add_run(run, products);
  }
  for (const BorderVertex& border : borders_) {
    const auto [a, b, number] = fields(border.vertex);
    add_border(border, weights[border.vertex], vector_of(a), vector_of(b), products);
  }
}

}  // namespace lamella::energy
