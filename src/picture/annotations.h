// What is written on a picture: a legend, axes, a scale bar, labels.
#pragma once

#include <string>
#include <vector>

#include "picture/camera.h"
#include "picture/content.h"
#include "picture/image.h"

typedef struct _cairo cairo_t;

namespace lamella::picture {

struct Annotations {
  bool legend = false;     // a colour bar, or the colours of bodies
  bool axes = false;       // the directions of x, y and z
  bool scale_bar = false;  // a round length, true at the depth of the scene's middle
  bool labels = false;     // the numbers of bodies

  bool any() const { return legend || axes || scale_bar || labels; }
};

// A word at a place of the drawing.
struct Label {
  Point at{};
  std::string text;
};

struct LegendEntry {
  std::string text;
  Colour colour;
};

// What there is to write.
struct Writing {
  Annotations wanted;
  Camera camera;
  double radius = 1;  // of the scene, the drawing's unit
  std::optional<ColourField> field;
  std::vector<LegendEntry> legend;  // where there is no field
  std::vector<Label> labels;
  Colour behind;  // what it is written on
};

// Writes upon an image.
void annotate(Image& image, const Writing& writing);

// Writes on any surface of this size.
void annotate(cairo_t* cairo, double width, double height, const Writing& writing);

}  // namespace lamella::picture
