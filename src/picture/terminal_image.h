// Pictures as a terminal shows them.
#pragma once

#include <string>
#include <string_view>

#include "picture/image.h"

namespace lamella::picture {

enum class TerminalColours : std::uint8_t {
  all,      // 24 bits
  palette,  // the 256 of xterm
};

// Two pixels a character, one above the other: the upper half block in one colour on another. A line for each
// two rows, each ended by a line feed.
std::string half_blocks(const Image& image, TerminalColours colours);

// As DEC's terminals take pictures: 252 colours, errors of which are spread over the neighbours.
std::string sixels(const Image& image);

// As kitty takes pictures: a PNG file in pieces. The picture is `columns` wide and `rows` high, in
// characters.
std::string kitty_picture(std::string_view png, int columns, int rows);

}  // namespace lamella::picture
