#include "picture/colour.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace lamella::picture {

namespace {

float light_of(double level) {
  return static_cast<float>(level <= 0.04045 ? level / 12.92 : std::pow((level + 0.055) / 1.055, 2.4));
}

double level_of(double light) {
  return light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1 / 2.4) - 0.055;
}

// Levels of sRGB by amounts of light; fine enough that each byte comes out right but where it is a tie.
constexpr int table_steps = 1 << 14;

std::array<std::uint8_t, table_steps + 1> make_byte_table() {
  std::array<std::uint8_t, table_steps + 1> table{};
  for (int i = 0; i <= table_steps; ++i) {
    table[static_cast<std::size_t>(i)] =
        static_cast<std::uint8_t>(std::lround(255 * level_of(static_cast<double>(i) / table_steps)));
  }
  return table;
}

}  // namespace

Colour srgb(std::uint32_t code) {
  const auto channel = [&](int shift) {
    return light_of(static_cast<double>((code >> shift) & 0xffU) / 255);
  };
  return {channel(16), channel(8), channel(0)};
}

std::uint8_t srgb_byte(float light) {
  static const auto table = make_byte_table();
  const float step = std::clamp(light, 0.0F, 1.0F) * table_steps + 0.5F;
  return table[static_cast<std::size_t>(step)];
}

// Evolver's names with hues that keep well together as tints of a film.
Colour evolver_colour(int number) {
  static const std::array<Colour, 16> colours = {
      srgb(0x23262b), srgb(0x2350c8), srgb(0x1f9d55), srgb(0x14a3a8), srgb(0xd0312d), srgb(0xb832b0),
      srgb(0x8a5a2b), srgb(0xb9bec4), srgb(0x62686f), srgb(0x6ea8f5), srgb(0x7bd88f), srgb(0x7fe3e6),
      srgb(0xf58a85), srgb(0xf09be8), srgb(0xf2d02c), srgb(0xffffff)};
  return number >= 0 && number < 16 ? colours[static_cast<std::size_t>(number)] : colours[evolver_white];
}

namespace {

constexpr std::array<std::string_view, 16> names = {
    "black",    "blue",      "green",      "cyan",      "red",      "magenta",      "brown",  "lightgray",
    "darkgray", "lightblue", "lightgreen", "lightcyan", "lightred", "lightmagenta", "yellow", "white"};

}  // namespace

std::optional<Colour> colour_named(std::string_view name) {
  if (name == "black") return Colour{0, 0, 0};  // evolver_colour's is softer
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (names[i] == name) return evolver_colour(static_cast<int>(i));
  }
  std::uint32_t code = 0;
  if (name.size() != 7 || name[0] != '#') return std::nullopt;
  const auto [end, error] = std::from_chars(name.data() + 1, name.data() + name.size(), code, 16);
  if (error != std::errc() || end != name.data() + name.size()) return std::nullopt;
  return srgb(code);
}

std::vector<std::string> colour_names() {
  return {names.begin(), names.end()};
}

}  // namespace lamella::picture
