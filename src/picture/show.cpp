#include "picture/show.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "picture/blending.h"
#include "picture/drawing.h"
#include "picture/painter.h"
#include "picture/png.h"
#include "text/error.h"
#include "text/whole_file.h"

namespace lamella::picture {

namespace {

void refuse_bad_size(const PictureOptions& options) {
  for (const int side : {options.width, options.height}) {
    if (side >= 1 && side <= largest_side) continue;
    throw text::Error(fmt::format("a picture cannot be {} by {} pixels", options.width, options.height),
                      fmt::format("width and height may be 1 to {}", largest_side));
  }
  if (options.samples < 1 || options.samples > 4) {
    throw text::Error(fmt::format("a picture cannot have {0} by {0} samples a pixel", options.samples),
                      "1 to 4 are possible");
  }
}

// Turns painted tiles into pixels of an image.
class Developer {
 public:
  Developer(Image& image, const PictureOptions& options) : image_(image), options_(options) {}

  // `x`, `y`: the image's pixel at the upper left of the tile.
  void develop(const PaintedTile& tile, int x, int y, int width, int height) const {
#pragma omp parallel
    {
      Blender blender;
#pragma omp for schedule(dynamic, 4)
      for (int row = 0; row < height; ++row) {
        for (int column = 0; column < width; ++column) {
          image_.at(x + column, y + row) =
              pixel(tile, column, height - 1 - row, background(y + row), blender);
        }
      }
    }
  }

 private:
  Colour background(int y) const {
    if (options_.transparent) return {};
    const float down = (static_cast<float>(y) + 0.5F) / static_cast<float>(image_.height);
    return mix(options_.style.background_top, options_.style.background_bottom, down);
  }

  // The mean over the samples; `row` counts from the bottom of the tile.
  Pixel pixel(const PaintedTile& tile, int column, int row, Colour behind, Blender& blender) const {
    const int n = options_.samples;
    Colour light;
    Colour clear;
    for (int j = 0; j < n; ++j) {
      for (int i = 0; i < n; ++i) {
        const auto sample = static_cast<std::size_t>(row * n + j) * static_cast<std::size_t>(tile.width) +
                            static_cast<std::size_t>(column * n + i);
        const float* tube = &tile.opaque[4 * sample];
        const float open = 1 - tube[3];
        const Layer films = blender.blend(tile.fragments, tile.first[sample]);
        const Layer seen = over(films, {{tube[0], tube[1], tube[2]}, {open, open, open}});
        light = light + seen.glow + seen.clear * behind;
        clear = clear + seen.clear;
      }
    }
    const float share = 1 / static_cast<float>(n * n);
    return options_.transparent ? translucent(share * light, share * clear) : opaque(share * light);
  }

  static Pixel opaque(Colour light) {
    return {srgb_byte(light.red), srgb_byte(light.green), srgb_byte(light.blue), 255};
  }

  static Pixel translucent(Colour light, Colour clear) {
    // One opacity for three channels: their mean, but enough to carry the brightest of them.
    const float mean = 1 - (clear.red + clear.green + clear.blue) / 3;
    const float opacity = std::clamp(std::max({mean, light.red, light.green, light.blue}), 0.0F, 1.0F);
    if (opacity <= 0) return {0, 0, 0, 0};
    Pixel pixel = opaque((1 / opacity) * light);
    pixel.opacity = static_cast<std::uint8_t>(255 * opacity + 0.5F);
    return pixel;
  }

  Image& image_;
  const PictureOptions& options_;
};

// Paints a rectangle of the image, in quarters where it holds too many films at once.
void paint_part(Painter& painter, const Developer& developer, const PictureOptions& options, int x, int y,
                int width, int height) {
  const int n = options.samples;
  PaintedTile painted;
  const Tile tile{options.width * n, options.height * n, x * n, y * n, width * n, height * n};
  if (painter.paint(tile, painted)) {
    developer.develop(painted, x, y, width, height);
    return;
  }
  if (width == 1 && height == 1) {
    throw text::Error("too many films lie behind one another", "fewer samples a pixel need less memory");
  }
  const int left = std::max(1, width / 2);
  const int top = std::max(1, height / 2);
  for (const int px : {0, left}) {
    for (const int py : {0, top}) {
      const int w = px == 0 ? left : width - left;
      const int h = py == 0 ? top : height - top;
      if (w > 0 && h > 0) paint_part(painter, developer, options, x + px, y + py, w, h);
    }
  }
}

std::vector<Point> outline(const Drawing& drawing) {
  std::vector<Point> points = drawing.positions;
  for (const Tube& tube : drawing.tubes) {
    points.push_back(tube.from);
    points.push_back(tube.to);
  }
  return points;
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
  painter.look_through(fit_camera(outline(drawing), drawing.largest_tube(), view, aspect));
  Image image(options.width, options.height);
  const Developer developer(image, options);
  const int side = Painter::largest_tile / options.samples;
  for (int y = 0; y < options.height; y += side) {
    for (int x = 0; x < options.width; x += side) {
      paint_part(painter, developer, options, x, y, std::min(side, options.width - x),
                 std::min(side, options.height - y));
    }
  }
  return image;
}

void show_file(const scene::Scene& scene, const std::string& path, const PictureOptions& options) {
  text::write_whole_file(path, encode_png(render(scene, options)));
}

}  // namespace lamella::picture
