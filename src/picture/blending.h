// Light through many films: the films that a pixel shows, put in order and blended.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "picture/colour.h"

namespace lamella::picture {

// What a film adds to the light behind it and what it lets through of it, channel by channel:
// seen light = glow + clear * light behind.
struct Layer {
  Colour glow;
  Colour clear{1, 1, 1};
};

constexpr Layer over(const Layer& front, const Layer& back) {
  return {front.glow + front.clear * back.glow, front.clear * back.clear};
}

// A film's layer at one pixel, as the shader packs it: three times 10 bits each, of sqrt(glow / 4) and of
// clear.
struct Fragment {
  float depth = 0;
  std::uint32_t next = end_of_list;
  std::uint32_t glow = 0;
  std::uint32_t clear = 0;

  static constexpr std::uint32_t end_of_list = 0xffffffffU;
};

Layer unpack(const Fragment& fragment);

// Blends the films of one pixel after another; holds its workspace in between.
class Blender {
 public:
  // All fragments of a list as one layer, whatever the order in the list. Fragments of equal depth come in
  // the order of their packed values, so that the result does not depend on chance.
  Layer blend(std::span<const Fragment> fragments, std::uint32_t first);

 private:
  std::vector<Fragment> sorted_;
};

}  // namespace lamella::picture
