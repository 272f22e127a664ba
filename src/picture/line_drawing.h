// A drawing in lines, as on paper: outlines, borders, rims, wires and creases, those hidden behind films
// apart.
#pragma once

#include <string>
#include <vector>

#include "picture/annotations.h"
#include "picture/camera.h"
#include "picture/drawing.h"
#include "picture/image.h"

namespace lamella::picture {

// In heights of the picture from its upper left corner.
struct Spot {
  double x = 0;
  double y = 0;
};

struct Stroke {
  std::vector<Spot> spots;
  LineKind kind = LineKind::border;  // none for the outline of a curved film
  bool hidden = false;               // at least one film lies before it
};

// The strokes of a picture; `aspect` is width over height. Strokes are split where films begin or cease to
// hide them, to a tenth of a thousandth of the picture's height, and are otherwise as long as they can be.
std::vector<Stroke> find_strokes(const Drawing& drawing, const Camera& camera, double aspect);

// The strokes in ink, hidden ones dashed and grey.
struct Paper {
  std::vector<Stroke> strokes;
  int width = 0;  // pixels, or points of a page
  int height = 0;
  Colour background{1, 1, 1};
  bool transparent = false;
  double line_width = 1;
  std::optional<Writing> writing;
};
Image paper_image(const Paper& paper);
std::string paper_svg(const Paper& paper);
std::string paper_pdf(const Paper& paper);

}  // namespace lamella::picture
