#include "picture/show.h"

#include <algorithm>

#include <fmt/format.h>

#include "picture/development.h"
#include "picture/drawing.h"
#include "picture/painter.h"
#include "picture/png.h"
#include "text/error.h"
#include "text/whole_file.h"

namespace lamella::picture {

namespace {

constexpr int most_samples = 64;

void refuse_bad_size(const PictureOptions& options) {
  for (const int side : {options.width, options.height}) {
    if (side >= 1 && side <= largest_side) continue;
    throw text::Error(fmt::format("a picture cannot be {} by {} pixels", options.width, options.height),
                      fmt::format("width and height may be 1 to {}", largest_side));
  }
  if (options.samples < 1 || options.samples > most_samples) {
    throw text::Error(fmt::format("a picture cannot have {} samples a pixel", options.samples),
                      fmt::format("1 to {} are possible", most_samples));
  }
}

// A rectangle of the image.
struct Part {
  int x = 0;
  int y = 0;
  int width = 0;
  int height = 0;
};

// False where more films lie behind one another than there is room for.
bool paint_part(Painter& painter, const PictureOptions& options, const Part& part, Image& image) {
  Exposure exposure(part.width, part.height);
  PaintedTile painted;
  for (const Offset& offset : sample_offsets(options.samples)) {
    const Tile tile{options.width, options.height, part.x,       part.y,
                    part.width,    part.height,    offset.right, offset.down};
    if (!painter.paint(tile, painted)) return false;
    exposure.add(painted);
  }
  exposure.develop(image, part.x, part.y, options.style, options.transparent);
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

void paint_all(Painter& painter, const PictureOptions& options, Image& image) {
  const auto tiles = [](int length) { return (length + Painter::largest_tile - 1) / Painter::largest_tile; };
  std::vector<Part> waiting =
      divide({0, 0, options.width, options.height}, tiles(options.width), tiles(options.height));
  while (!waiting.empty()) {
    const Part part = waiting.back();
    waiting.pop_back();
    if (paint_part(painter, options, part, image)) continue;
    if (part.width == 1 && part.height == 1)
      throw text::Error("too many films lie behind one another to draw them");
    const std::vector<Part> smaller = divide(part, std::min(2, part.width), std::min(2, part.height));
    waiting.insert(waiting.end(), smaller.begin(), smaller.end());
  }
}

}  // namespace

Image render(const scene::Scene& scene, const PictureOptions& options) {
  refuse_bad_size(options);
  const Drawing drawing = draw(scene, options.style);
  if (drawing.empty()) {
    throw text::Error("there is nothing to draw: the scene has no facet and no edge",
                      "load a datafile first, e.g. load datafiles/double_bubble.fe");
  }
  const View view = options.view ? *options.view : view_of(scene);
  const double aspect = static_cast<double>(options.width) / options.height;
  Painter painter(drawing, options.style);
  // Films that are shrunk to a point are still looked at from a distance.
  const double around = std::max(drawing.largest_tube(), 1e-3);
  painter.look_through(fit_camera(drawing.outline(), around, view, aspect));
  Image image(options.width, options.height);
  paint_all(painter, options, image);
  return image;
}

void show_file(const scene::Scene& scene, const std::string& path, const PictureOptions& options) {
  text::write_whole_file(path, encode_png(render(scene, options)));
}

}  // namespace lamella::picture
