// Numbers as colours.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "picture/colour.h"

namespace lamella::picture {

enum class ColourMap : std::uint8_t {
  viridis,    // dark blue over green to yellow: equal steps look equal, in print and to the colour-blind too
  diverging,  // blue over pale grey to red: for numbers around a middle
  grey,       // black to white
};
std::span<const std::string_view> colour_map_names();  // in the order of the enumerators
ColourMap colour_map_named(std::string_view name);     // one of these

// `part` runs from 0 to 1; beyond that it is cut.
Colour colour_of(ColourMap map, double part);

// Round numbers for the ticks of a scale from low to high, at most `most` of them.
std::vector<double> round_ticks(double low, double high, int most);

// Colours that are told apart well, for things without an order; after `count` they begin again.
Colour distinct_colour(std::size_t number);

}  // namespace lamella::picture
