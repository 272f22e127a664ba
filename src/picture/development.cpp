#include "picture/development.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace lamella::picture {

// The golden ratio spreads the rows: for a Fibonacci number of points no pattern of this kind is more even.
std::vector<Offset> sample_offsets(int count) {
  constexpr double golden = 0.6180339887498949;
  const auto part = [&](int i) { return i * golden - std::floor(i * golden); };
  std::vector<int> by_height(static_cast<std::size_t>(count));
  std::iota(by_height.begin(), by_height.end(), 0);
  std::sort(by_height.begin(), by_height.end(), [&](int i, int j) { return part(i) < part(j); });
  std::vector<Offset> offsets(by_height.size());
  for (std::size_t row = 0; row < by_height.size(); ++row) {
    const auto middle = [&](double cell) { return (cell + 0.5) / count - 0.5; };
    offsets[static_cast<std::size_t>(by_height[row])] = {middle(by_height[row]),
                                                         middle(static_cast<double>(row))};
  }
  return offsets;
}

namespace {

Colour background(const Style& style, int y, int height) {
  const float down = (static_cast<float>(y) + 0.5F) / static_cast<float>(height);
  return mix(style.background_top, style.background_bottom, down);
}

Pixel opaque_pixel(Colour light) {
  return {srgb_byte(light.red), srgb_byte(light.green), srgb_byte(light.blue), 255};
}

// One opacity for three channels: their mean, but enough to carry the brightest of them.
Pixel translucent_pixel(const Layer& seen) {
  const float mean = 1 - (seen.clear.red + seen.clear.green + seen.clear.blue) / 3;
  const float opacity =
      std::clamp(std::max({mean, seen.glow.red, seen.glow.green, seen.glow.blue}), 0.0F, 1.0F);
  if (opacity <= 0) return {0, 0, 0, 0};
  Pixel pixel = opaque_pixel((1 / opacity) * seen.glow);
  pixel.opacity = static_cast<std::uint8_t>(255 * opacity + 0.5F);
  return pixel;
}

}  // namespace

Exposure::Exposure(int width, int height)
    : width_(width),
      height_(height),
      sums_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), Layer{{0, 0, 0}, {0, 0, 0}}) {
}

void Exposure::add(const PaintedTile& painted) {
  ++looks_;
  const auto pixels = static_cast<std::ptrdiff_t>(sums_.size());
#pragma omp parallel
  {
    Blender blender;
#pragma omp for schedule(dynamic, 4096)
    for (std::ptrdiff_t i = 0; i < pixels; ++i) {
      const auto pixel = static_cast<std::size_t>(i);
      const float* tube = &painted.opaque[4 * pixel];
      const float open = 1 - tube[3];
      const Layer films = blender.blend(painted.fragments, painted.first[pixel]);
      const Layer seen = over(films, {{tube[0], tube[1], tube[2]}, {open, open, open}});
      sums_[pixel] = {sums_[pixel].glow + seen.glow, sums_[pixel].clear + seen.clear};
    }
  }
}

void Exposure::develop(Image& image, int x, int y, const Style& style, bool transparent) const {
  const float share = 1 / static_cast<float>(looks_);
  for (int row = 0; row < height_; ++row) {
    const Colour behind = background(style, y + row, image.height);
    const Layer* sums =
        &sums_[static_cast<std::size_t>(height_ - 1 - row) * static_cast<std::size_t>(width_)];
    Pixel* pixels = &image.at(x, y + row);
    for (int column = 0; column < width_; ++column) {
      const Layer seen{share * sums[column].glow, share * sums[column].clear};
      pixels[column] = transparent ? translucent_pixel(seen) : opaque_pixel(seen.glow + seen.clear * behind);
    }
  }
}

}  // namespace lamella::picture
