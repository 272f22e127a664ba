// How a picture looks, as data.
#pragma once

#include <optional>

#include "picture/colour.h"

namespace lamella::picture {

// A line of the film: lengths are fractions of the radius of the scene.
struct LineStyle {
  Colour colour;
  double radius = 0;
  double gloss = 0.5;  // strength of its highlights
};

// The light that surrounds the scene, as films and tubes reflect it. It turns with the camera.
struct Surroundings {
  Colour above = srgb(0xdbe6f2);
  Colour level = srgb(0x7f95b0);
  Colour below = srgb(0x34445c);
};

struct FilmStyle {
  double opacity = 0.11;          // seen head on
  double grazing = 0.92;          // seen edge on
  double falloff = 2.4;           // how late the one becomes the other
  double iridescence = 0.85;      // 0 grey to 1 full interference colours
  double thickness_top = 200;     // nanometres at the highest point of the scene,
  double thickness_bottom = 560;  // and at the lowest: films drain downwards
  double highlights = 1.0;
  double tint_opacity = 0.25;   // added where a facet has a colour of its own
  std::optional<Colour> paint;  // the colour of facets that have none of their own
  bool faceted = false;         // each facet is lit as the flat triangle that it is
  bool by_region = false;       // facets have the colours of the regions that they bound
};

struct Style {
  Colour background_top = srgb(0xf6f8fb);
  Colour background_bottom = srgb(0xc5d0dc);
  Surroundings surroundings;
  FilmStyle film;
  LineStyle border{srgb(0x56708f), 0.0058, 0.9};  // three or more films meet
  LineStyle rim{srgb(0x56708f), 0.0058, 0.9};     // a film ends
  LineStyle crease{srgb(0x8fa3b8), 0.0025, 0.3};  // a film bends sharply
  LineStyle wire{srgb(0xa8703f), 0.012, 1.0};     // fixed, or without films
  LineStyle mesh{srgb(0x3c4754), 0, 0.1};         // all other edges; not drawn at radius 0
  bool line_drawing = false;                      // lines on paper (line_drawing.h) instead of light
  double quad_point = 1.7;                        // radius where four borders meet, in radii of a border
  double haze = 0.35;                             // how far the most distant parts fade into the background
  double crease_angle = 50;                       // degrees: facets that meet at more are not shaded as one
};

}  // namespace lamella::picture
