// Wavefront OBJ files.
#pragma once

#include <string>

#include "exchange/mesh.h"
#include "exchange/parts.h"

namespace lamella::exchange {

// Shared vertices; a group `film_A_B` for each pair of regions, with A the lower one, in front; borders, rims
// and wires as lines in groups of their own.
std::string write_obj(const Mesh& mesh);

// One part, such as the surface of a body.
std::string write_obj(const Mesh& mesh, const Part& part);

}  // namespace lamella::exchange
