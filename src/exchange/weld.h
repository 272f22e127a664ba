// Loose polygons made one complex: points that lie together become one, polygons become triangles.
#pragma once

#include "exchange/mesh.h"
#include "exchange/soup.h"

namespace lamella::exchange {

struct Welded {
  std::vector<film::Vec3> points;
  std::vector<Triple> triangles;
  std::vector<film::RegionPair> regions;  // one a triangle, or none
  std::vector<std::array<std::uint32_t, 2>> wires;
  std::vector<WireKind> wire_kinds;
  std::size_t merged_points = 0;
  std::size_t dropped = 0;     // triangles without three different corners
  std::size_t duplicates = 0;  // triangles that another one covers
};

// Points at most `tolerance` from one met earlier are that one. Points that nothing uses are left out.
Welded weld(const Soup& soup, double tolerance);

// The diagonal of the box around all points.
double diagonal(const std::vector<film::Vec3>& points);

// A flat polygon, convex or not, cut into triangles: indices into `points`, wound alike. A polygon that
// crosses itself is cut from its first corner.
std::vector<Triple> triangulate(const std::vector<film::Vec3>& points,
                                std::span<const std::uint32_t> polygon);

}  // namespace lamella::exchange
