// Cones over nets on a sphere, for tests of what happens at a point.
#pragma once

#include <array>
#include <vector>

#include "scene/scene.h"
#include "support/shapes.h"

namespace lamella::test {

// Each face of a net is a cycle of points, counterclockwise seen from outside; face i is region i + 1.
struct Net {
  std::vector<Vec3> points;
  std::vector<std::vector<int>> faces;
};

inline Net cube_net(double height = 1) {
  Net net;
  for (int i = 0; i < 8; ++i)
    net.points.push_back({2.0 * (i & 1) - 1, 2.0 * ((i >> 1) & 1) - 1, height * (2.0 * ((i >> 2) & 1) - 1)});
  net.faces = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  return net;
}

inline Net prism_net(int sides, double half_height) {
  Net net;
  for (const double z : {-half_height, half_height}) {
    for (int i = 0; i < sides; ++i)
      net.points.push_back({std::cos(2 * M_PI * i / sides), std::sin(2 * M_PI * i / sides), z});
  }
  std::vector<int> bottom, top;
  for (int i = 0; i < sides; ++i) {
    const int next = (i + 1) % sides;
    bottom.push_back(sides - 1 - i);
    top.push_back(sides + i);
    net.faces.push_back({i, next, sides + next, sides + i});
  }
  net.faces.push_back(bottom);
  net.faces.push_back(top);
  return net;
}

inline Net octahedron_net() {
  Net net;
  net.points = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  net.faces = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  return net;
}

inline Net tetrahedron_net() {
  Net net;
  net.points = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
  net.faces = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}};
  return net;
}

struct Cone {
  scene::Scene scene;
  Vertex centre;
};

// Facets from a centre to each edge of the net; the net's points are fixed. Without regions, both sides of
// every facet are the outside.
inline Cone cone_over(const Net& net, bool with_regions = true) {
  Builder b;
  const Vertex centre = b.vertex({0, 0, 0});
  std::vector<Vertex> outer;
  for (const Vec3& p : net.points) outer.push_back(b.vertex(p));
  std::map<std::pair<int, int>, int> left;
  for (std::size_t f = 0; f < net.faces.size(); ++f) {
    const auto& face = net.faces[f];
    for (std::size_t i = 0; i < face.size(); ++i)
      left[{face[i], face[(i + 1) % face.size()]}] = static_cast<int>(f) + 1;
  }
  for (const auto& [way, region] : left) {
    if (way.first > way.second) continue;
    const int right = left.at({way.second, way.first});
    RegionPair pair{Region{static_cast<std::uint32_t>(region)}, Region{static_cast<std::uint32_t>(right)}};
    if (!with_regions) pair = {};
    b.triangle(centre, outer[std::size_t(way.first)], outer[std::size_t(way.second)], pair);
  }
  b.film.sort_all_sides();
  Cone cone;
  cone.scene.film = std::move(b.film);
  for (std::size_t f = 0; with_regions && f < net.faces.size(); ++f) cone.scene.bodies.emplace_back();
  auto& fixed = cone.scene.film.columns(film::ElementKind::vertex)
                    .add(film::flag_column("fixed", film::Inheritance::New::parent));
  for (const Vertex v : outer) fixed.set(v.index, 0, 1);
  auto& wires = cone.scene.film.columns(film::ElementKind::edge).add(film::flag_column("fixed"));
  for (std::uint32_t e = 0; e < cone.scene.film.edge_rows(); ++e) {
    const auto& ends = cone.scene.film.ends(film::Edge(e));
    if (ends[0] != centre && ends[1] != centre) wires.set(e, 0, 1);
  }
  cone.centre = centre;
  return cone;
}

}  // namespace lamella::test
