// From what was painted to the pixels of an image.
#pragma once

#include <vector>

#include "picture/blending.h"
#include "picture/image.h"
#include "picture/painter.h"
#include "picture/style.h"

namespace lamella::picture {

struct Offset {
  double right = 0;
  double down = 0;
};

// Where in a pixel to look, relative to its middle: no two points in one row or column of a grid of count *
// count, so that edges of every direction become smooth.
std::vector<Offset> sample_offsets(int count);

// The light of a tile, gathered over several looks at it.
class Exposure {
 public:
  Exposure(int width, int height);

  // Blends the films of each pixel and adds the outcome.
  void add(const PaintedTile& painted);

  // The mean of all looks, before the style's background or before none, at the place of the tile in the
  // image.
  void develop(Image& image, int x, int y, const Style& style, bool transparent) const;

 private:
  int width_;
  int height_;
  int looks_ = 0;
  std::vector<Layer> sums_;  // rows from the bottom to the top
};

}  // namespace lamella::picture
