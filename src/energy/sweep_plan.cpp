// Cutting a film's triangles into parts that threads can sweep side by side.
#include <algorithm>
#include <cmath>

#include "energy/lanes.h"
#include "energy/sweep.h"

namespace lamella::energy {

namespace {

using Range = SweepPlan::Range;

constexpr std::size_t worth_threads = 49152;  // triangles
constexpr std::size_t most_parts = 32;
// What lies between parts is swept on one thread: a film that has more of it is scattered in memory.
constexpr double most_between = 0.25;

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

SweepPlan::SweepPlan(std::span<const std::array<film::Vertex, 3>> triangles, std::size_t regions)
    : regions_(regions) {
  if (triangles.size() < worth_threads) return;
  const std::size_t batches = (triangles.size() + lanes - 1) / lanes;
  const std::size_t each = (batches + parts_for(triangles.size()) - 1) / parts_for(triangles.size());
  const auto part_of = [&](std::size_t triangle) {
    return static_cast<std::int32_t>(triangle / lanes / each);
  };
  std::uint32_t vertices = 0;
  for (const auto& corners : triangles)
    for (const film::Vertex v : corners) vertices = std::max(vertices, v.index + 1);
  std::vector<std::int32_t> owner(vertices, nobody);
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    for (const film::Vertex v : triangles[t]) {
      std::int32_t& part = owner[v.index];
      part = part == nobody || part == part_of(t) ? part_of(t) : several;
    }
  }
  std::vector<std::vector<Range>> parts((batches + each - 1) / each);
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
  if (static_cast<double>(left) > most_between * static_cast<double>(triangles.size())) {
    between_.clear();
    return;
  }
  parts_ = std::move(parts);
  sums_.resize(parts_.size() + 1);
  volumes_.resize((parts_.size() + 1) * regions);
}

}  // namespace lamella::energy
