#include "datafile/oddities.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

namespace lamella::datafile {

namespace {

using film::ElementKind;
using film::SignedEdge;
using film::Vec3;
using film::Vertex;

constexpr double same_point = 1e-12;  // relative to the size of the scene
constexpr double no_area = 1e-14;     // relative to the square of the perimeter

// The longest side of the box around the points.
double extent(const std::vector<Vec3>& positions) {
  if (positions.empty()) return 0;
  Vec3 low = positions.front();
  Vec3 high = low;
  for (const Vec3& p : positions) {
    for (int axis = 0; axis < 3; ++axis) {
      low[axis] = std::min(low[axis], p[axis]);
      high[axis] = std::max(high[axis], p[axis]);
    }
  }
  const Vec3 size = high - low;
  return std::max({size.x, size.y, size.z});
}

// Points that coincide have nearly the same height along every direction; along a direction like this one no
// others do, so that a look at the neighbours in the order of heights finds them.
void warn_of_coincident_vertices(Reading& reading) {
  const std::vector<Vec3>& positions = reading.rows.positions;
  const Vec3 direction{0.5257311121, 0.6180339887, 0.5842208333};
  const double tolerance = same_point * extent(positions);
  std::vector<std::pair<double, std::uint32_t>> heights;
  heights.reserve(positions.size());
  for (std::uint32_t v = 0; v < positions.size(); ++v) {
    if (!reading.rows.is_broken(ElementKind::vertex, v))
      heights.emplace_back(dot(positions[v], direction), v);
  }
  std::sort(heights.begin(), heights.end());
  const Numbering& vertices = reading.rows.of(ElementKind::vertex);
  constexpr std::size_t farthest =
      100;  // neighbours looked at, should a scene stand across the direction after all
  for (std::size_t i = 1; i < heights.size(); ++i) {
    const std::size_t stop = i > farthest ? i - farthest : 0;
    for (std::size_t j = i; j-- > stop && heights[i].first - heights[j].first <= 2 * tolerance;) {
      const auto [first, second] = std::minmax(heights[i].second, heights[j].second);
      if (length(positions[first] - positions[second]) > tolerance) continue;
      const text::Place other = reading.tokens.place(vertices.spots[first]);
      reading.findings.warning(reading.tokens.place(vertices.spots[second]),
                               fmt::format("vertex {} stands at the same point as vertex {}",
                                           vertices.ids[second], vertices.ids[first]),
                               {}, {{other, fmt::format("vertex {}", vertices.ids[first])}});
      break;
    }
  }
}

class FaceCheck {
 public:
  FaceCheck(Reading& reading, const Resolved& resolved)
      : reading_(reading), resolved_(resolved), faces_(reading.rows.of(ElementKind::facet)) {}

  void run();

 private:
  std::span<const SignedEdge> loop(std::size_t face) const {
    return {resolved_.loops.data() + reading_.rows.loops.begin(face), reading_.rows.loops.size(face)};
  }
  std::vector<Vertex> sorted_corners(std::size_t face) const;
  bool has_no_area(std::size_t face) const;
  void warn_of_doubled_faces();

  Reading& reading_;
  const Resolved& resolved_;
  const Numbering& faces_;
};

std::vector<Vertex> FaceCheck::sorted_corners(std::size_t face) const {
  std::vector<Vertex> corners;
  for (const SignedEdge e : loop(face)) corners.push_back(resolved_.tail(e));
  std::sort(corners.begin(), corners.end());
  return corners;
}

bool FaceCheck::has_no_area(std::size_t face) const {
  const auto position = [&](Vertex v) { return reading_.rows.positions[v.index]; };
  const std::span<const SignedEdge> edges = loop(face);
  const Vec3 origin = position(resolved_.tail(edges.front()));
  double area = 0;
  double perimeter = 0;
  for (const SignedEdge e : edges) {
    const Vec3 a = position(resolved_.tail(e));
    const Vec3 b = position(resolved_.head(e));
    area += 0.5 * length(cross(a - origin, b - origin));
    perimeter += length(b - a);
  }
  return area <= no_area * perimeter * perimeter;
}

// The same for faces with the same corners, in whatever order.
std::uint64_t corner_hash(const std::vector<Vertex>& sorted_corners) {
  std::uint64_t hash = sorted_corners.size();
  for (const Vertex v : sorted_corners) {
    hash = (hash ^ v.index) * 0x9e3779b97f4a7c15U;
    hash ^= hash >> 32U;
  }
  return hash;
}

void FaceCheck::warn_of_doubled_faces() {
  std::vector<std::pair<std::uint64_t, std::uint32_t>> hashes;
  hashes.reserve(faces_.size());
  for (std::uint32_t face = 0; face < faces_.size(); ++face) {
    if (resolved_.sound_faces[face] != 0) hashes.emplace_back(corner_hash(sorted_corners(face)), face);
  }
  std::sort(hashes.begin(), hashes.end());
  for (std::size_t i = 1; i < hashes.size(); ++i) {
    const std::uint32_t face = hashes[i].second;
    const std::uint32_t other = hashes[i - 1].second;
    if (hashes[i].first != hashes[i - 1].first || sorted_corners(face) != sorted_corners(other)) continue;
    reading_.findings.warning(
        reading_.tokens.place(faces_.spots[face]),
        fmt::format("face {} has the same vertices as face {}", faces_.ids[face], faces_.ids[other]), {},
        {{reading_.tokens.place(faces_.spots[other]), fmt::format("face {}", faces_.ids[other])}});
  }
}

void FaceCheck::run() {
  if (reading_.periods || reading_.scene.strings.on) return;  // faces may well differ by how they go around
  warn_of_doubled_faces();
  for (std::size_t face = 0; face < faces_.size(); ++face) {
    if (resolved_.sound_faces[face] == 0 || !has_no_area(face)) continue;
    reading_.findings.warning(
        reading_.tokens.place(faces_.spots[face]),
        fmt::format("face {} has no area: its vertices lie on one line", faces_.ids[face]));
  }
}

}  // namespace

void warn_of_oddities(Reading& reading, const Resolved& resolved) {
  warn_of_coincident_vertices(reading);
  // Where something is wrong already, faces may look odd for that reason.
  if (!reading.findings.has_errors()) FaceCheck(reading, resolved).run();
}

}  // namespace lamella::datafile
