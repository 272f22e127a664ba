#include "exchange/weld.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <unordered_map>

namespace lamella::exchange {

using film::Vec3;

namespace {

// Points met so far, in cells of the tolerance's size: what is near lies in a cell or one beside it.
class Welder {
 public:
  explicit Welder(double tolerance) : tolerance_(tolerance) {}

  // The number of the point met first at this place.
  std::uint32_t number(const Vec3& p) {
    const Cell own = cell_of(p);
    const int reach = tolerance_ > 0 ? 1 : 0;
    for (long x = -reach; x <= reach; ++x) {
      for (long y = -reach; y <= reach; ++y) {
        for (long z = -reach; z <= reach; ++z) {
          const auto at = cells_.find({own[0] + x, own[1] + y, own[2] + z});
          if (at == cells_.end()) continue;
          for (const std::uint32_t candidate : at->second) {
            if (length(points[candidate] - p) <= tolerance_) return candidate;
          }
        }
      }
    }
    points.push_back(p);
    cells_[own].push_back(static_cast<std::uint32_t>(points.size() - 1));
    return static_cast<std::uint32_t>(points.size() - 1);
  }

  std::vector<Vec3> points;

 private:
  using Cell = std::array<long, 3>;
  struct Hash {
    std::size_t operator()(const Cell& c) const {
      std::size_t h = 0;
      for (const long x : c) h = (h ^ static_cast<std::size_t>(x)) * 0x9e3779b97f4a7c15U;
      return h ^ (h >> 29);
    }
  };

  // Without a tolerance each number is a cell of its own (0 and -0 are one).
  Cell cell_of(const Vec3& p) const {
    Cell cell{};
    for (int k = 0; k < 3; ++k) {
      cell[static_cast<std::size_t>(k)] = tolerance_ > 0 ? static_cast<long>(std::floor(p[k] / tolerance_))
                                                         : static_cast<long>(std::hash<double>{}(p[k] + 0.0));
    }
    return cell;
  }

  double tolerance_;
  std::unordered_map<Cell, std::vector<std::uint32_t>, Hash> cells_;
};

bool is_even(const Triple& t) {
  return (t[0] < t[1]) + (t[1] < t[2]) + (t[2] < t[0]) == 2;
}

// Takes triangles one by one; what is covered already or has no area by its corners is only counted.
class TriangleCollector {
 public:
  explicit TriangleCollector(Welded& welded) : welded_(welded) {}

  void add(const Triple& t, const film::RegionPair* regions) {
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) {
      ++welded_.dropped;
      return;
    }
    Triple key = t;
    std::sort(key.begin(), key.end());
    const auto [at, made] = known_.try_emplace(key, static_cast<std::uint32_t>(welded_.triangles.size()));
    if (!made) {
      ++welded_.duplicates;
      if (regions != nullptr) cover(at->second, t, *regions);
      return;
    }
    welded_.triangles.push_back(t);
    if (regions != nullptr) welded_.regions.push_back(*regions);
  }

 private:
  // Two closed bodies that share a wall each know their own side of it only.
  void cover(std::uint32_t earlier, const Triple& t, film::RegionPair regions) {
    if (is_even(t) != is_even(welded_.triangles[earlier])) regions = regions.flipped();
    film::RegionPair& known = welded_.regions[earlier];
    if (known.front.outside()) known.front = regions.front;
    if (known.behind.outside()) known.behind = regions.behind;
  }

  Welded& welded_;
  std::map<Triple, std::uint32_t> known_;
};

// A polygon as cells on both of its sides would have it: from its lowest corner towards the lower neighbour
// of that. Returns whether it was turned. So two cells that share a polygon cut it alike.
bool make_canonical(std::vector<std::uint32_t>& polygon) {
  std::rotate(polygon.begin(), std::min_element(polygon.begin(), polygon.end()), polygon.end());
  if (polygon[1] < polygon.back()) return false;
  std::reverse(polygon.begin() + 1, polygon.end());
  return true;
}

void weld_wires(Welded& welded, const Soup& soup, const std::vector<std::uint32_t>& number) {
  for (std::size_t i = 0; i < soup.wires.size(); ++i) {
    const std::array<std::uint32_t, 2> ends = {number[soup.wires[i][0]], number[soup.wires[i][1]]};
    if (ends[0] == ends[1]) continue;
    welded.wires.push_back(ends);
    welded.wire_kinds.push_back(soup.wire_kinds[i]);
  }
}

void drop_unused_points(Welded& welded) {
  std::vector<std::uint32_t> number(welded.points.size(), film::no_index);
  std::vector<Vec3> kept;
  const auto renumber = [&](std::uint32_t& p) {
    if (number[p] == film::no_index) {
      number[p] = static_cast<std::uint32_t>(kept.size());
      kept.push_back(welded.points[p]);
    }
    p = number[p];
  };
  for (Triple& t : welded.triangles) std::for_each(t.begin(), t.end(), renumber);
  for (auto& wire : welded.wires) std::for_each(wire.begin(), wire.end(), renumber);
  welded.points = std::move(kept);
}

}  // namespace

double diagonal(const std::vector<Vec3>& points) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Vec3 low{infinity, infinity, infinity};
  Vec3 high = -low;
  for (const Vec3& p : points) {
    for (int k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], p[k]);
      high[k] = std::max(high[k], p[k]);
    }
  }
  return points.empty() ? 0 : length(high - low);
}

Welded weld(const Soup& soup, double tolerance) {
  Welder welder(tolerance);
  std::vector<std::uint32_t> number;
  number.reserve(soup.points.size());
  for (const Vec3& p : soup.points) number.push_back(welder.number(p));
  Welded welded;
  welded.merged_points = soup.points.size() - welder.points.size();
  welded.points = std::move(welder.points);
  TriangleCollector collector(welded);
  std::uint32_t begin = 0;
  for (std::size_t i = 0; i < soup.size(); ++i) {
    std::vector<std::uint32_t> polygon;
    for (std::uint32_t k = begin; k < soup.ends[i]; ++k) {
      const std::uint32_t p = number[soup.corners[k]];
      if (polygon.empty() || polygon.back() != p) polygon.push_back(p);
    }
    begin = soup.ends[i];
    while (polygon.size() > 1 && polygon.front() == polygon.back()) polygon.pop_back();
    if (polygon.size() < 3) {
      ++welded.dropped;
      continue;
    }
    const film::RegionPair* const regions = soup.regions.empty() ? nullptr : &soup.regions[i];
    const bool turned = make_canonical(polygon);
    for (const Triple& t : triangulate(welded.points, polygon))
      collector.add(turned ? Triple{t[0], t[2], t[1]} : t, regions);
  }
  weld_wires(welded, soup, number);
  drop_unused_points(welded);
  return welded;
}

}  // namespace lamella::exchange
