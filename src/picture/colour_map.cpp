#include "picture/colour_map.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace lamella::picture {

namespace {

constexpr std::array<std::string_view, 3> map_names = {"viridis", "diverging", "grey"};

// Mixed in sRGB, in which the steps between these colours are even.
std::uint32_t mixed(std::uint32_t a, std::uint32_t b, double part) {
  std::uint32_t result = 0;
  for (const int shift : {16, 8, 0}) {
    const double low = (a >> shift) & 255U;
    const double high = (b >> shift) & 255U;
    result |= static_cast<std::uint32_t>(std::lround(low + part * (high - low))) << shift;
  }
  return result;
}

Colour between(std::span<const std::uint32_t> stops, double part) {
  const double at = std::clamp(part, 0.0, 1.0) * static_cast<double>(stops.size() - 1);
  const auto first = std::min(static_cast<std::size_t>(at), stops.size() - 2);
  return srgb(mixed(stops[first], stops[first + 1], at - static_cast<double>(first)));
}

}  // namespace

std::span<const std::string_view> colour_map_names() {
  return map_names;
}

ColourMap colour_map_named(std::string_view name) {
  return static_cast<ColourMap>(std::find(map_names.begin(), map_names.end(), name) - map_names.begin());
}

Colour colour_of(ColourMap map, double part) {
  static constexpr std::array<std::uint32_t, 10> viridis = {0x440154, 0x482878, 0x3e4989, 0x31688e, 0x26828e,
                                                            0x1f9e89, 0x35b779, 0x6ece58, 0xb5de2b, 0xfde725};
  static constexpr std::array<std::uint32_t, 7> diverging = {0x2a3f8f, 0x4a7fc4, 0xa9c9e4, 0xececec,
                                                             0xf0b89c, 0xd8644e, 0x96182e};
  static constexpr std::array<std::uint32_t, 2> grey = {0x101010, 0xf4f4f4};
  switch (map) {
    case ColourMap::diverging:
      return between(diverging, part);
    case ColourMap::grey:
      return between(grey, part);
    default:
      return between(viridis, part);
  }
}

std::vector<double> round_ticks(double low, double high, int most) {
  std::vector<double> ticks;
  const double range = high - low;
  if (!(range > 0)) return {low};
  double unit = std::pow(10.0, std::floor(std::log10(range / most)));
  for (const double factor : {1.0, 2.0, 5.0, 10.0}) {
    if (range / (factor * unit) > most) continue;
    unit *= factor;
    break;
  }
  for (double at = std::ceil(low / unit - 1e-9); at * unit <= high + 1e-9 * range; ++at)
    ticks.push_back(at * unit + 0.0);
  return ticks;
}

Colour distinct_colour(std::size_t number) {
  static constexpr std::array<std::uint32_t, 12> colours = {0x3b7dd8, 0xe2803a, 0x3fa66b, 0xc8504f,
                                                            0x8a68c4, 0xd9b13b, 0x38a9b3, 0xcf6fa8,
                                                            0x7d9a3c, 0x8c6d5a, 0x5f7387, 0xa8c4e6};
  return srgb(colours[number % colours.size()]);
}

}  // namespace lamella::picture
