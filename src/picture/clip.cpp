#include "picture/clip.h"

#include <cstdint>
#include <unordered_map>
#include <utility>

namespace lamella::picture {

namespace {

using Corners = std::array<std::uint32_t, 3>;

Point mixed(const Point& a, const Point& b, float part) {
  return {a[0] + part * (b[0] - a[0]), a[1] + part * (b[1] - a[1]), a[2] + part * (b[2] - a[2])};
}

class Clipper {
 public:
  Clipper(Drawing& drawing, const ClippingPlane& plane) : drawing_(drawing), normal_(unit(plane.normal)) {
    const double length = film::length(plane.normal);
    offset_ = (plane.offset / length - dot(normal_, drawing.middle)) / drawing.radius;
    beyond_.reserve(drawing.positions.size());
    for (const Point& p : drawing.positions) beyond_.push_back(distance(p));
  }

  void run() {
    const std::vector<Corners> triangles = std::exchange(drawing_.triangles, {});
    const std::vector<Tint> tints = std::exchange(drawing_.tints, {});
    const std::vector<film::RegionPair> regions = std::exchange(drawing_.regions, {});
    for (std::size_t t = 0; t < triangles.size(); ++t) {
      const std::size_t before = drawing_.triangles.size();
      cut(triangles[t]);
      drawing_.regions.resize(drawing_.triangles.size(), regions[t]);
      if (!tints.empty())
        drawing_.tints.resize(drawing_.tints.size() + drawing_.triangles.size() - before, tints[t]);
    }
    std::vector<Tube> tubes;
    for (Tube tube : drawing_.tubes) {
      if (cut(tube)) tubes.push_back(tube);
    }
    drawing_.tubes = std::move(tubes);
  }

 private:
  float distance(const Point& p) const {
    return static_cast<float>(dot(normal_, film::Vec3{p[0], p[1], p[2]}) - offset_);
  }

  // From the first corner that stays after one that goes, a triangle that is cut keeps one corner or two.
  void cut(const Corners& t) {
    int kept = 0;
    for (const std::uint32_t v : t) kept += beyond_[v] <= 0 ? 1 : 0;
    if (kept == 3) drawing_.triangles.push_back(t);
    if (kept == 0 || kept == 3) return;
    std::size_t k = 0;
    while (beyond_[t[k]] > 0 || beyond_[t[(k + 2) % 3]] <= 0) ++k;
    const std::uint32_t a = t[k];
    const std::uint32_t b = t[(k + 1) % 3];
    const std::uint32_t c = t[(k + 2) % 3];
    const std::uint32_t ca = between(c, a);
    if (kept == 1) {
      drawing_.triangles.push_back({a, between(a, b), ca});
    } else {
      const std::uint32_t bc = between(b, c);
      drawing_.triangles.push_back({a, b, bc});
      drawing_.triangles.push_back({a, bc, ca});
    }
  }

  // The vertex on the plane between two, shared by the triangles on both sides.
  std::uint32_t between(std::uint32_t a, std::uint32_t b) {
    if (a > b) std::swap(a, b);
    const auto [at, is_new] = made_.try_emplace(std::uint64_t{a} << 32U | b, 0);
    if (!is_new) return at->second;
    const float part = beyond_[a] / (beyond_[a] - beyond_[b]);
    const auto mean = [&](float x, float y) { return x + part * (y - x); };
    at->second = static_cast<std::uint32_t>(drawing_.positions.size());
    drawing_.positions.push_back(mixed(drawing_.positions[a], drawing_.positions[b], part));
    drawing_.normals.push_back(mixed(drawing_.normals[a], drawing_.normals[b], part));
    drawing_.bends.push_back(mean(drawing_.bends[a], drawing_.bends[b]));
    drawing_.thickness.push_back(mean(drawing_.thickness[a], drawing_.thickness[b]));
    if (!drawing_.vertex_tints.empty()) {
      const VertexTint& one = drawing_.vertex_tints[a];
      const VertexTint& other = drawing_.vertex_tints[b];
      drawing_.vertex_tints.push_back(
          {mix(one.colour, other.colour, part), mean(one.strength, other.strength)});
    }
    beyond_.push_back(0);
    return at->second;
  }

  bool cut(Tube& tube) const {
    const float from = distance(tube.from);
    const float to = distance(tube.to);
    if (from > 0 && to > 0) return false;
    if (from <= 0 && to <= 0) return true;
    const Point at = mixed(tube.from, tube.to, from / (from - to));
    (from > 0 ? tube.from : tube.to) = at;
    return true;
  }

  Drawing& drawing_;
  film::Vec3 normal_;
  double offset_ = 0;
  std::vector<float> beyond_;  // one a vertex: its distance beyond the plane
  std::unordered_map<std::uint64_t, std::uint32_t> made_;
};

template <class T>
void keep(std::vector<T>& values, const std::vector<std::uint32_t>& kept) {
  if (values.empty()) return;
  std::vector<T> result;
  result.reserve(kept.size());
  for (const std::uint32_t v : kept) result.push_back(values[v]);
  values = std::move(result);
}

}  // namespace

void clip(Drawing& drawing, const ClippingPlane& plane) {
  Clipper(drawing, plane).run();
}

void drop_unused_vertices(Drawing& drawing) {
  constexpr std::uint32_t unused = 0xffffffffU;
  std::vector<std::uint32_t> row(drawing.positions.size(), unused);
  std::vector<std::uint32_t> kept;
  for (Corners& t : drawing.triangles) {
    for (std::uint32_t& v : t) {
      if (row[v] == unused) {
        row[v] = static_cast<std::uint32_t>(kept.size());
        kept.push_back(v);
      }
      v = row[v];
    }
  }
  keep(drawing.positions, kept);
  keep(drawing.normals, kept);
  keep(drawing.bends, kept);
  keep(drawing.thickness, kept);
  keep(drawing.vertex_tints, kept);
}

}  // namespace lamella::picture
