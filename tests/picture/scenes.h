// Small scenes made by formula, to be drawn in tests.
#pragma once

#include <map>
#include <utility>
#include <vector>

#include "scene/scene.h"

namespace lamella::picture::scenes {

// Builds a film from triangles given by their corners; corners at the same place are one vertex.
class Builder {
 public:
  film::Vertex vertex(const film::Vec3& p);
  film::Edge edge(film::Vertex a, film::Vertex b);
  void triangle(film::Vertex a, film::Vertex b, film::Vertex c, film::RegionPair regions = {});
  // A flat four-sided film divided into n times n squares.
  void patch(const film::Vec3& a, const film::Vec3& b, const film::Vec3& c, const film::Vec3& d, int n,
             film::RegionPair regions = {});
  void fix(film::Edge e);
  scene::Scene finish();

 private:
  film::SignedEdge signed_edge(film::Vertex a, film::Vertex b);

  scene::Scene scene_;
  std::map<std::array<long, 3>, film::Vertex> vertex_at_;
  std::map<std::pair<film::Vertex, film::Vertex>, film::Edge> edge_between_;
  std::vector<film::Edge> fixed_;
};

// A film in a square frame in the plane z = height.
scene::Scene square_film(int n, double height = 0);
// Two square films of side 2, one above the other, the upper one shifted by 1 along x and y.
scene::Scene two_square_films(int n);
scene::Scene sphere(int n);
// Two bubbles along x of radii 1 and `second` (at most 1) with the film between them, by three spherical
// caps.
scene::Scene double_bubble(int n, double second);
// The frame of a cube with 13 flat films.
scene::Scene wire_cube(int n);
// A catenoid between two wire rings around z.
scene::Scene catenoid(int n);
// n * n * n cubic bubbles that share their walls, each wall divided into m * m squares.
scene::Scene lattice(int n, int m);
// Truncated octahedra that fill a cube of n * n * n cells twice over: Kelvin's foam.
scene::Scene kelvin(int n, int m);
// A one-sided band of `turns` half turns between its wires.
scene::Scene twisted_band(int n, int turns);

}  // namespace lamella::picture::scenes
