// The files of VTK and ParaView.
#pragma once

#include <string>
#include <vector>

#include "exchange/mesh.h"

namespace lamella::exchange {

// PolyData (.vtp): lines and triangles. Cells have "kind" (0 film, 1 border, 2 rim, 3 wire), "front" and
// "behind" (-1 for lines) and the attributes of triangles (not a number, or -1, for lines).
std::string write_vtp(const Mesh& mesh);

// The same as an unstructured grid (.vtu).
std::string write_vtu(const Mesh& mesh);

// A series of such files (.pvd).
struct Moment {
  double time = 0;
  std::string file;  // beside the series' own
};
std::string write_pvd(const std::vector<Moment>& moments);

}  // namespace lamella::exchange
