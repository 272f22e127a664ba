// Colours as light: linear red, green and blue, 1 for the white of the screen.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace lamella::picture {

struct Colour {
  float red = 0;
  float green = 0;
  float blue = 0;

  friend constexpr Colour operator+(Colour a, Colour b) {
    return {a.red + b.red, a.green + b.green, a.blue + b.blue};
  }
  friend constexpr Colour operator*(Colour a, Colour b) {
    return {a.red * b.red, a.green * b.green, a.blue * b.blue};
  }
  friend constexpr Colour operator*(float s, Colour a) { return {s * a.red, s * a.green, s * a.blue}; }
};

constexpr Colour mix(Colour a, Colour b, float part) {
  return (1 - part) * a + part * b;
}

// The colour written 0xRRGGBB in sRGB, as painting programs and web pages write it.
Colour srgb(std::uint32_t code);

// One of the sixteen names below, or #rrggbb; nothing for other words.
std::optional<Colour> colour_named(std::string_view name);
// The names, without #rrggbb.
std::vector<std::string> colour_names();

// The sRGB byte of an amount of light, rounded; amounts beyond [0, 1] are cut.
std::uint8_t srgb_byte(float light);

// Evolver's colours 0 to 15 (black, blue, ... white); others count as white.
Colour evolver_colour(int number);

inline constexpr int evolver_black = 0;
inline constexpr int evolver_white = 15;
inline constexpr int evolver_clear = -1;  // not drawn

}  // namespace lamella::picture
