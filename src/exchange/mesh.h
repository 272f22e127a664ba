// A scene as other programs take it: points, triangles and lines with plain numbers.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "film/film.h"
#include "picture/drawing.h"
#include "scene/scene.h"

namespace lamella::exchange {

using Triple = std::array<std::uint32_t, 3>;

// Numbers of each point or triangle, `width` of them a row.
struct Attribute {
  std::string name;  // letters, digits and underscores
  int width = 1;
  bool whole = false;  // integers of 32 bits
  std::vector<double> values;
};

// A border, rim or wire from one of its ends to the other; a loop ends at its first point.
struct Line {
  picture::LineKind kind = picture::LineKind::border;
  std::vector<std::uint32_t> points;
};

// Points are shared by all triangles and lines that meet there. Triangles are counterclockwise seen from the
// region in front.
struct Mesh {
  std::vector<film::Vec3> points;
  std::vector<Triple> triangles;
  std::vector<film::RegionPair> regions;  // one a triangle
  std::vector<Line> lines;
  std::vector<Attribute> of_points;
  std::vector<Attribute> of_triangles;
};

// All of a scene's film, with the numbers that people see ("id") and its columns as attributes. Where a film
// runs around a period of space, its corners beyond are points of their own, so that no triangle is torn.
Mesh mesh_of(const scene::Scene& scene);

std::string_view name_of(picture::LineKind kind);

}  // namespace lamella::exchange
