// Draws a drawing, tile by tile, to fragments in memory.
#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "picture/blending.h"
#include "picture/drawing.h"
#include "picture/style.h"

namespace lamella::picture {

// A rectangle of a picture of `picture_width` times `picture_height` pixels; x and y of its upper left pixel,
// counted from the upper left of the picture. One point of each pixel is looked at: its middle, moved by
// right and down, in pixels.
struct Tile {
  int picture_width = 0;
  int picture_height = 0;
  int x = 0;
  int y = 0;
  int width = 0;
  int height = 0;
  double right = 0;
  double down = 0;
  std::span<const std::uint8_t> wanted = {};  // one a pixel, rows from the bottom; empty: all of them
};

// What a tile shows. Rows run from the bottom to the top; the views are valid until the next tile is painted.
struct PaintedTile {
  std::span<const std::uint32_t> first;  // one a pixel: the first of its fragments, or Fragment::end_of_list
  std::span<const Fragment> fragments;   // films, but for those hidden behind a tube
  std::span<const float> opaque;         // four a pixel: light of a tube and 1, or zeros
};

class Painter {
 public:
  // Both outlive the painter. Tiles are at most this wide and high.
  Painter(const Drawing& drawing, const Style& style, int tile_width, int tile_height);
  ~Painter();

  void look_through(const Camera& camera);

  // False where the tile shows more fragments than there is room for: try smaller ones.
  bool paint(const Tile& tile, PaintedTile& painted);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace lamella::picture
