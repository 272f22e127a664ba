// Lines of a film as solid tubes.
#pragma once

#include "exchange/mesh.h"

namespace lamella::exchange {

struct Solid {
  std::vector<film::Vec3> points;
  std::vector<film::Vec3> normals;
  std::vector<Triple> triangles;
};

// Appends a tube of this radius along a line, with round rings that are not twisted.
void add_tube(Solid& solid, const Mesh& mesh, const Line& line, double radius);

// Appends a ball.
void add_ball(Solid& solid, const film::Vec3& middle, double radius);

// The tubes of all lines of one kind, as wide as they are in pictures of style film, and for borders the
// balls where four or more of them meet.
Solid tubes_of(const Mesh& mesh, picture::LineKind kind, double radius);

}  // namespace lamella::exchange
