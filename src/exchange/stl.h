// STL files, binary.
#pragma once

#include <string>

#include "exchange/mesh.h"
#include "exchange/parts.h"

namespace lamella::exchange {

std::string write_stl(const Mesh& mesh);

// One part, such as the surface of a body.
std::string write_stl(const Mesh& mesh, const Part& part);

}  // namespace lamella::exchange
