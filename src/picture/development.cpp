#include "picture/development.h"

#include <algorithm>
#include <array>
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
      looks_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 0.0F),
      sums_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), Layer{{0, 0, 0}, {0, 0, 0}}) {
}

void Exposure::add(const PaintedTile& painted, std::span<const std::uint8_t> wanted) {
  const auto pixels = static_cast<std::ptrdiff_t>(sums_.size());
  // Few pixels are not worth waking other threads, which keep a processor busy when they wait for more.
#pragma omp parallel if (wanted.empty())
  {
    Blender blender;
#pragma omp for schedule(dynamic, 16384)
    for (std::ptrdiff_t i = 0; i < pixels; ++i) {
      const auto pixel = static_cast<std::size_t>(i);
      if (!wanted.empty() && wanted[pixel] == 0) continue;
      looks_[pixel] += 1;
      const float* tube = &painted.opaque[4 * pixel];
      Layer seen;
      if (painted.first[pixel] != Fragment::end_of_list) {
        seen = blender.blend(painted.fragments, painted.first[pixel]);
      }
      if (tube[3] > 0) {
        const float open = 1 - tube[3];
        seen = over(seen, {{tube[0], tube[1], tube[2]}, {open, open, open}});
      }
      sums_[pixel] = {sums_[pixel].glow + seen.glow, sums_[pixel].clear + seen.clear};
    }
  }
}

// Light is compared by its root, much as eyes do.
std::vector<std::uint8_t> Exposure::uneven(const Colour& behind) const {
  constexpr float visible = 0.02F;
  const auto width = static_cast<std::size_t>(width_);
  std::vector<std::array<float, 3>> seen(sums_.size());
  for (std::size_t i = 0; i < seen.size(); ++i) {
    const Colour light = sums_[i].glow + sums_[i].clear * behind;
    seen[i] = {std::sqrt(light.red), std::sqrt(light.green), std::sqrt(light.blue)};
  }
  std::vector<std::uint8_t> result(sums_.size(), 0);
  const auto compare = [&](std::size_t i, std::size_t j) {
    float most = 0;
    for (std::size_t k = 0; k < 3; ++k) most = std::max(most, std::abs(seen[i][k] - seen[j][k]));
    if (most > visible) result[i] = result[j] = 1;
  };
  for (int y = 0; y < height_; ++y) {
    for (int x = 0; x < width_; ++x) {
      const std::size_t i = static_cast<std::size_t>(y) * width + static_cast<std::size_t>(x);
      if (x + 1 < width_) compare(i, i + 1);
      if (y + 1 < height_) compare(i, i + width);
    }
  }
  return result;
}

void Exposure::develop(Image& image, int x, int y, const Style& style, bool transparent,
                       const CastShadow& shadow) const {
  for (int row = 0; row < height_; ++row) {
    const Colour behind = background(style, y + row, image.height);
    const std::size_t first = static_cast<std::size_t>(height_ - 1 - row) * static_cast<std::size_t>(width_);
    const Layer* sums = &sums_[first];
    Pixel* pixels = &image.at(x, y + row);
    for (int column = 0; column < width_; ++column) {
      const float share = 1 / looks_[first + static_cast<std::size_t>(column)];
      const float light = shadow.light(x + column, y + row, image.width, image.height);
      const Layer seen{share * sums[column].glow, light * share * sums[column].clear};
      pixels[column] = transparent ? translucent_pixel(seen) : opaque_pixel(seen.glow + seen.clear * behind);
    }
  }
}

}  // namespace lamella::picture
