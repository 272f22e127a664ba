// A picture in memory.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace lamella::picture {

// Red, green, blue and opacity, one byte each: sRGB, opacity not multiplied in.
struct Pixel {
  std::uint8_t red = 0;
  std::uint8_t green = 0;
  std::uint8_t blue = 0;
  std::uint8_t opacity = 255;

  friend constexpr bool operator==(const Pixel&, const Pixel&) = default;
};

// Rows from top to bottom, each from left to right.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<Pixel> pixels;

  Image() = default;
  Image(int w, int h)
      : width(w), height(h), pixels(static_cast<std::size_t>(w) * static_cast<std::size_t>(h)) {}

  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
  }
  Pixel& at(int x, int y) { return pixels[index(x, y)]; }
  const Pixel& at(int x, int y) const { return pixels[index(x, y)]; }
};

}  // namespace lamella::picture
