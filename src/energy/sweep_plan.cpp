// Cutting a film's triangles into parts that threads can sweep side by side.
#include <algorithm>
#include <cmath>

#include "energy/lanes.h"
#include "energy/sweep.h"

namespace lamella::energy {

namespace {

using Range = SweepPlan::Range;
using Triangles = std::span<const std::array<film::Vertex, 3>>;

constexpr std::size_t worth_threads = 49152;  // triangles
constexpr std::size_t most_parts = 32;
// What lies between parts is swept on one thread: a film that has more of it is scattered in memory.
constexpr double most_between = 0.25;

// Few enough for what they touch to stay in the nearest cache but one.
constexpr std::uint32_t triangles_a_stage = 512;

constexpr std::int32_t nobody = -1;
constexpr std::int32_t several = -2;

// A cut through a film that lies by place crosses some sqrt(triangles): with more parts than this, too much
// would lie between them.
std::size_t parts_for(std::size_t triangles) {
  const auto parts = static_cast<std::size_t>(std::sqrt(static_cast<double>(triangles)) / 64);
  return std::clamp<std::size_t>(parts, 2, most_parts);
}

void append(std::vector<Range>& ranges, Range next) {
  if (!ranges.empty() && ranges.back().last == next.first)
    ranges.back().last = next.last;
  else
    ranges.push_back(next);
}

}  // namespace

SweepPlan::SweepPlan(Triangles triangles, std::size_t rows, std::size_t regions) : regions_(regions) {
  plan_stages(cut(triangles, rows), triangles, rows);
  sums_.resize(stages_.size() + 1);
  volumes_.resize((stages_.size() + 1) * regions);
}

// Parts as lists of ranges, and what lies between them.
SweepPlan::Parts SweepPlan::cut(Triangles triangles, std::size_t rows) {
  const Parts whole{{{0, static_cast<std::uint32_t>(triangles.size())}}};
  if (triangles.size() < worth_threads) return whole;
  const std::size_t batches = (triangles.size() + lanes - 1) / lanes;
  const std::size_t each = (batches + parts_for(triangles.size()) - 1) / parts_for(triangles.size());
  const auto part_of = [&](std::size_t triangle) {
    return static_cast<std::int32_t>(triangle / lanes / each);
  };
  std::vector<std::int32_t> owner(rows, nobody);
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    for (const film::Vertex v : triangles[t]) {
      std::int32_t& part = owner[v.index];
      part = part == nobody || part == part_of(t) ? part_of(t) : several;
    }
  }
  Parts parts((batches + each - 1) / each);
  std::size_t left = 0;
  for (std::size_t first = 0; first < triangles.size(); first += lanes) {
    const std::size_t last = std::min(first + lanes, triangles.size());
    bool inside = true;
    for (std::size_t t = first; t < last; ++t)
      for (const film::Vertex v : triangles[t]) inside = inside && owner[v.index] != several;
    if (!inside) left += last - first;
    append(inside ? parts[static_cast<std::size_t>(part_of(first))] : between_,
           {static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(last)});
  }
  if (static_cast<double>(left) <= most_between * static_cast<double>(triangles.size())) return parts;
  between_.clear();
  return whole;
}

namespace {

// Rows of a part by its stages.
class StageRows {
 public:
  // A row belongs to the first stage whose bound lies above it; bounds rise, the last above all rows.
  StageRows(std::span<const Range> rows, std::span<const std::uint32_t> bounds) {
    std::size_t stage = 0;
    for (const Range& range : rows) {
      for (std::uint32_t row = range.first; row < range.last;) {
        while (bounds[stage] <= row) {
          ++stage;
          first_.push_back(ranges_.size());
        }
        const std::uint32_t last = std::min(range.last, bounds[stage]);
        ranges_.push_back({row, last});
        row = last;
      }
    }
    first_.resize(bounds.size() + 1, ranges_.size());
  }
  std::vector<Range> take_ranges() { return std::move(ranges_); }
  std::span<const Range> of(std::size_t stage, std::span<const Range> ranges) const {
    return ranges.subspan(first_[stage], first_[stage + 1] - first_[stage]);
  }

 private:
  std::vector<std::size_t> first_{0};
  std::vector<Range> ranges_;
};

// Which part has a row to itself, and which of its stages touch it first and last.
struct Touch {
  std::int32_t part = nobody;
  std::uint32_t first = 0;
  std::uint32_t last = 0;
};

void touch(std::vector<Touch>& touches, std::int32_t part, std::span<const SweepPlan::Stage> stages,
           Triangles triangles) {
  for (std::uint32_t s = 0; s < stages.size(); ++s) {
    for (std::uint32_t t = stages[s].triangles.first; t < stages[s].triangles.last; ++t) {
      for (const film::Vertex v : triangles[t]) {
        Touch& touch = touches[v.index];
        if (touch.part == nobody) touch = {part, s, s};
        touch.last = s;
      }
    }
  }
}

}  // namespace

// A row is fresh at the first stage from which on no row below it waits for its first triangle, and done
// where no row below it waits for its last one: so rows come in ascending order, in long ranges if the film
// lies by place.
void SweepPlan::plan_stages(const Parts& parts, Triangles triangles, std::size_t rows) {
  std::vector<Touch> touches(rows);
  stages_.resize(parts.size());
  for (std::size_t p = 0; p < parts.size(); ++p) {
    for (const Range& range : parts[p]) {
      for (std::uint32_t first = range.first; first < range.last; first += triangles_a_stage)
        stages_[p].push_back({{first, std::min(first + triangles_a_stage, range.last)}, {}, {}});
    }
    touch(touches, static_cast<std::int32_t>(p), stages_[p], triangles);
  }
  for (const Range& range : between_) {
    for (std::uint32_t t = range.first; t < range.last; ++t)
      for (const film::Vertex v : triangles[t]) touches[v.index].part = several;
  }
  std::vector<std::vector<Range>> own(parts.size());
  std::vector<std::vector<std::uint32_t>> fresh_below(parts.size());
  std::vector<std::vector<std::uint32_t>> done_below(parts.size());
  for (std::size_t p = 0; p < parts.size(); ++p) {
    fresh_below[p].assign(stages_[p].size(), 0);
    done_below[p].assign(stages_[p].size(), static_cast<std::uint32_t>(rows));
  }
  for (std::uint32_t v = 1; v < rows; ++v) {
    const Touch& touch = touches[v];
    if (touch.part < 0) {
      append(shared_rows_, {v, v + 1});
      continue;
    }
    const auto p = static_cast<std::size_t>(touch.part);
    append(own[p], {v, v + 1});
    fresh_below[p][touch.first] = v + 1;
    if (touch.last > 0) done_below[p][touch.last - 1] = std::min(done_below[p][touch.last - 1], v);
  }
  for (std::size_t p = 0; p < parts.size(); ++p) {
    for (std::size_t s = 1; s < stages_[p].size(); ++s)
      fresh_below[p][s] = std::max(fresh_below[p][s], fresh_below[p][s - 1]);
    for (std::size_t s = stages_[p].size(); s > 1; --s)
      done_below[p][s - 2] = std::min(done_below[p][s - 2], done_below[p][s - 1]);
    StageRows fresh(own[p], fresh_below[p]);
    StageRows done(own[p], done_below[p]);
    ranges_.push_back(fresh.take_ranges());
    const std::span<const Range> fresh_ranges = ranges_.back();
    ranges_.push_back(done.take_ranges());
    const std::span<const Range> done_ranges = ranges_.back();
    for (std::size_t s = 0; s < stages_[p].size(); ++s) {
      stages_[p][s].fresh = fresh.of(s, fresh_ranges);
      stages_[p][s].done = done.of(s, done_ranges);
    }
  }
}

}  // namespace lamella::energy
