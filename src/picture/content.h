// What of a scene a picture shows, and in which colours.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "film/film.h"
#include "film/vec3.h"
#include "picture/colour_map.h"

namespace lamella::picture {

// A number of each facet or vertex, shown as colours between those of `low` and `high`.
struct ColourField {
  film::ElementKind of = film::ElementKind::facet;  // or vertex
  std::vector<double> values;                       // one a row; not a number: no colour
  double low = 0;
  double high = 1;
  ColourMap map = ColourMap::viridis;
  std::string title;
};

// What lies on the side of the normal, at more than `offset` along it, is cut away.
struct ClippingPlane {
  film::Vec3 normal;
  double offset = 0;
};

// A ball around the scene: the origin and the unit of a drawing's coordinates.
struct Surrounding {
  film::Vec3 middle;
  double radius = 1;
};

struct Content {
  std::vector<std::uint8_t> facets;  // one a row: whether it is drawn; empty for all
  std::optional<ColourField> field;
  std::vector<double> thickness;  // nanometres, one a vertex row; empty for that of the style
  std::optional<ClippingPlane> clip;
  double explode = 0;                      // how far bodies move out, in distances from the scene's middle
  std::optional<Surrounding> surrounding;  // the scene's own unless given
};

}  // namespace lamella::picture
