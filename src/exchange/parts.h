// Parts of a mesh: the closed surface of each body, the films between borders.
#pragma once

#include <vector>

#include "exchange/mesh.h"

namespace lamella::exchange {

// Triangles with points of their own.
struct Part {
  film::RegionPair regions;
  std::vector<std::uint32_t> points;  // of the mesh
  std::vector<Triple> triangles;      // of these points
  bool closed = true;                 // each side of a triangle meets another the other way round
};

// Each body's surface seen from outside: `regions.behind` is the body. Bodies without triangles are left out.
std::vector<Part> bodies_of(const Mesh& mesh);

// The pieces of film between borders, rims and wires, each wound one way as far as it has two sides.
std::vector<Part> films_of(const Mesh& mesh);

// Of unit length, one a point of the part; smooth.
std::vector<film::Vec3> normals_of(const Mesh& mesh, const Part& part);

}  // namespace lamella::exchange
