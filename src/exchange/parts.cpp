#include "exchange/parts.h"

#include <algorithm>
#include <map>
#include <unordered_map>

namespace lamella::exchange {

using film::Region;
using film::RegionPair;
using film::Vec3;

namespace {

Triple turned(const Triple& t) {
  return {t[0], t[2], t[1]};
}

// Numbers the points that triangles of a mesh use, in the order in which they are met.
class PartMaker {
 public:
  explicit PartMaker(RegionPair regions) { part_.regions = regions; }

  void add(const Triple& corners) {
    Triple own{};
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [at, made] =
          number_.try_emplace(corners[k], static_cast<std::uint32_t>(part_.points.size()));
      if (made) part_.points.push_back(corners[k]);
      own[k] = at->second;
    }
    part_.triangles.push_back(own);
  }

  Part finish() {
    std::map<std::array<std::uint32_t, 2>, long> balance;
    for (const Triple& t : part_.triangles) {
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t a = t[k];
        const std::uint32_t b = t[(k + 1) % 3];
        balance[{std::min(a, b), std::max(a, b)}] += a < b ? 1 : -1;
      }
    }
    part_.closed =
        std::all_of(balance.begin(), balance.end(), [](const auto& side) { return side.second == 0; });
    return std::move(part_);
  }

 private:
  Part part_;
  std::unordered_map<std::uint32_t, std::uint32_t> number_;
};

// Triangles across the side of a triangle, where exactly two meet there.
class Neighbours {
 public:
  explicit Neighbours(const Mesh& mesh) : mesh_(mesh) {
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
      for (std::size_t k = 0; k < 3; ++k) at_[key(mesh.triangles[t], k)].push_back(t);
    }
    for (const Line& line : mesh.lines) {
      for (std::size_t i = 1; i < line.points.size(); ++i)
        at_.erase(std::minmax(line.points[i - 1], line.points[i]));
    }
  }

  // no_index where there is none.
  std::uint32_t across(std::uint32_t t, std::size_t k) const {
    const auto found = at_.find(key(mesh_.triangles[t], k));
    if (found == at_.end() || found->second.size() != 2) return film::no_index;
    return found->second[0] == t ? found->second[1] : found->second[0];
  }

 private:
  static std::pair<std::uint32_t, std::uint32_t> key(const Triple& t, std::size_t k) {
    return std::minmax(t[k], t[(k + 1) % 3]);
  }

  const Mesh& mesh_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::uint32_t>> at_;
};

bool walks(const Triple& t, std::uint32_t from, std::uint32_t to) {
  for (std::size_t k = 0; k < 3; ++k) {
    if (t[k] == from && t[(k + 1) % 3] == to) return true;
  }
  return false;
}

}  // namespace

std::vector<Part> bodies_of(const Mesh& mesh) {
  std::map<std::uint32_t, PartMaker> makers;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const RegionPair pair = mesh.regions[t];
    if (pair.front == pair.behind) continue;
    const auto maker = [&](Region region) -> PartMaker& {
      return makers.try_emplace(region.index, RegionPair{Region{0}, region}).first->second;
    };
    if (!pair.behind.outside()) maker(pair.behind).add(mesh.triangles[t]);
    if (!pair.front.outside()) maker(pair.front).add(turned(mesh.triangles[t]));
  }
  std::vector<Part> parts;
  for (auto& [region, maker] : makers) parts.push_back(maker.finish());
  return parts;
}

std::vector<Part> films_of(const Mesh& mesh) {
  const Neighbours neighbours(mesh);
  std::vector<std::uint8_t> taken(mesh.triangles.size(), 0);
  std::vector<Part> parts;
  for (std::uint32_t first = 0; first < mesh.triangles.size(); ++first) {
    if (taken[first] != 0) continue;
    PartMaker maker(mesh.regions[first]);
    std::vector<std::pair<std::uint32_t, Triple>> open = {{first, mesh.triangles[first]}};
    taken[first] = 1;
    while (!open.empty()) {
      const auto [t, wound] = open.back();
      open.pop_back();
      maker.add(wound);
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t next = neighbours.across(t, k);
        if (next == film::no_index || taken[next] != 0) continue;
        taken[next] = 1;
        const auto& side = mesh.triangles[t];
        const std::uint32_t a = side[k];
        const std::uint32_t b = side[(k + 1) % 3];
        const bool same = walks(wound, a, b) != walks(mesh.triangles[next], a, b);
        open.emplace_back(next, same ? mesh.triangles[next] : turned(mesh.triangles[next]));
      }
    }
    parts.push_back(maker.finish());
  }
  return parts;
}

std::vector<Vec3> normals_of(const Mesh& mesh, const Part& part) {
  std::vector<Vec3> normals(part.points.size());
  for (const Triple& t : part.triangles) {
    const auto at = [&](std::size_t k) { return mesh.points[part.points[t[k]]]; };
    const Vec3 area = cross(at(1) - at(0), at(2) - at(0));
    for (const std::uint32_t v : t) normals[v] += area;
  }
  for (Vec3& normal : normals) normal = length(normal) > 0 ? unit(normal) : Vec3{0, 0, 1};
  return normals;
}

}  // namespace lamella::exchange
