#include "picture/light.h"

#include <algorithm>
#include <vector>

#include "picture/development.h"
#include "picture/painter.h"
#include "text/error.h"

namespace lamella::picture {

namespace {

struct Look {
  const Style& style;
  int samples = 1;
  bool transparent = false;
  CastShadow shadow;
};

// A rectangle of the image.
struct Part {
  int x = 0;
  int y = 0;
  int width = 0;
  int height = 0;
};

// False where more films lie behind one another than there is room for.
bool paint_part(Painter& painter, const Look& look, const Part& part, Image& image) {
  Exposure exposure(part.width, part.height);
  PaintedTile painted;
  std::vector<std::uint8_t> wanted;
  for (const Offset& offset : sample_offsets(look.samples)) {
    const Tile tile{image.width, image.height, part.x,      part.y, part.width,
                    part.height, offset.right, offset.down, wanted};
    if (!painter.paint(tile, painted)) return false;
    exposure.add(painted, wanted);
    if (wanted.empty()) wanted = exposure.uneven(look.style.background_top);
  }
  exposure.develop(image, part.x, part.y, look.style, look.transparent, look.shadow);
  return true;
}

// Divides a part into equal ones, `columns` by `rows`.
std::vector<Part> divide(const Part& whole, int columns, int rows) {
  std::vector<Part> parts;
  const auto at = [](int length, int i, int count) {
    return static_cast<int>(static_cast<long>(length) * i / count);
  };
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      const int x = at(whole.width, i, columns);
      const int y = at(whole.height, j, rows);
      parts.push_back(
          {whole.x + x, whole.y + y, at(whole.width, i + 1, columns) - x, at(whole.height, j + 1, rows) - y});
    }
  }
  return parts;
}

// Tiles that a processor's cache can nearly hold.
constexpr int largest_tile = 800;

int tile_count(int length) {
  return (length + largest_tile - 1) / largest_tile;
}

int tile_length(int length) {
  return (length + tile_count(length) - 1) / tile_count(length);
}

void paint_all(Painter& painter, const Look& look, Image& image) {
  std::vector<Part> waiting =
      divide({0, 0, image.width, image.height}, tile_count(image.width), tile_count(image.height));
  while (!waiting.empty()) {
    const Part part = waiting.back();
    waiting.pop_back();
    if (paint_part(painter, look, part, image)) continue;
    if (part.width == 1 && part.height == 1)
      throw text::Error("too many films lie behind one another to draw them");
    const std::vector<Part> smaller = divide(part, std::min(2, part.width), std::min(2, part.height));
    waiting.insert(waiting.end(), smaller.begin(), smaller.end());
  }
}

}  // namespace

void paint_light(Image& image, const Drawing& drawing, const Camera& camera, const Style& style, int samples,
                 bool transparent, bool shadow) {
  const GroundShadow ground = shadow ? GroundShadow(drawing) : GroundShadow();
  Painter painter(drawing, style, tile_length(image.width), tile_length(image.height));
  painter.look_through(camera);
  paint_all(painter, {style, samples, transparent, {ground, camera}}, image);
}

}  // namespace lamella::picture
