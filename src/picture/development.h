// From what was painted to the pixels of an image.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "picture/blending.h"
#include "picture/image.h"
#include "picture/painter.h"
#include "picture/shadow.h"
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

  // Blends the films of each pixel and adds the outcome; after the first look, of the pixels given by
  // `wanted` (one a pixel; empty: all).
  void add(const PaintedTile& painted, std::span<const std::uint8_t> wanted = {});

  // After the first look: the pixels at which the picture is not smooth, so that more looks are worth it.
  std::vector<std::uint8_t> uneven(const Colour& behind) const;

  // The mean of all looks, before the style's background or before none, at the place of the tile in the
  // image. A shadow dims what is behind.
  void develop(Image& image, int x, int y, const Style& style, bool transparent,
               const CastShadow& shadow) const;

 private:
  int width_;
  int height_;
  std::vector<float> looks_;  // one a pixel
  std::vector<Layer> sums_;   // rows from the bottom to the top
};

}  // namespace lamella::picture
