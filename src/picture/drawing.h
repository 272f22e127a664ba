// What a picture shows, taken out of a scene: triangles with normals, tubes and balls.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "picture/camera.h"
#include "picture/colour.h"
#include "picture/content.h"
#include "picture/style.h"
#include "scene/scene.h"

namespace lamella::picture {

// What a line of a film is: where three or more films meet, where one ends, a wire (fixed, or without films),
// a sharp bend, or any other edge of the mesh.
enum class LineKind : std::uint32_t { none, border, rim, wire, crease, mesh };

// A round line with round ends; a ball where both ends are one point.
struct Tube {
  Point from{};
  float radius = 0;
  Point to{};
  float gloss = 0;
  Colour colour;
  LineKind kind = LineKind::wire;
};

// A facet's colours seen from its front and from behind. Plain films have none: strength 0.
struct Tint {
  Colour front{1, 1, 1};
  float front_strength = 0;
  Colour behind{1, 1, 1};
  float behind_strength = 0;
};

// A colour that changes within facets.
struct VertexTint {
  Colour colour{1, 1, 1};
  float strength = 0;
};

// Coordinates are relative to the middle of the scene, in units of its radius: floats keep what a picture
// needs wherever the scene stands.
struct Drawing {
  std::vector<Point> positions;
  std::vector<Point> normals;
  std::vector<float>
      bends;  // how strongly the film is curved at a vertex: 1 where it is a sphere of the scene's radius
  std::vector<float> thickness;          // nanometres
  std::vector<VertexTint> vertex_tints;  // one a vertex, or none
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<film::RegionPair> regions;  // one a triangle
  std::vector<Tint> tints;                // one a triangle, or none where no facet is coloured
  std::vector<Tube> tubes;
  film::Vec3 middle;
  double radius = 1;

  bool empty() const { return triangles.empty() && tubes.empty(); }
  double largest_tube() const;
  Point place(const film::Vec3& p) const;  // of a point of the scene
  std::vector<Point> outline() const;  // all points that a picture must contain, but for the radii of tubes
};

// Throws text::Error where a coordinate is not finite.
Drawing draw(const scene::Scene& scene, const Style& style, const Content& content = {});

// The colour of a region in pictures by region.
Colour region_colour(film::Region region);

}  // namespace lamella::picture
