// PLY files, binary.
#pragma once

#include <string>

#include "exchange/mesh.h"
#include "exchange/parts.h"

namespace lamella::exchange {

// Vertices, faces with `front`, `behind` and the attributes, and the edges of borders, rims and wires with
// their `kind` (1, 2 and 3). Facets with colours of their own have `red`, `green` and `blue`.
std::string write_ply(const Mesh& mesh);

// One part, with normals if `normals` is not empty.
std::string write_ply(const std::vector<film::Vec3>& points, const std::vector<film::Vec3>& normals,
                      const std::vector<Triple>& triangles);

}  // namespace lamella::exchange
