// What the terminal can show, by asking it.
#pragma once

#include <chrono>
#include <string>
#include <string_view>

#include "picture/terminal_image.h"

namespace lamella::session {

enum class PictureWay : std::uint8_t { half_blocks, sixel, kitty };

struct TerminalLooks {
  PictureWay way = PictureWay::half_blocks;
  picture::TerminalColours colours = picture::TerminalColours::palette;
  int cell_width = 8;  // of a character, in pixels
  int cell_height = 16;
};

struct WindowSize {
  int columns = 80;
  int rows = 24;
};

// What a terminal's answers say; what else came (typed meanwhile) is in `rest`.
struct Answers {
  bool kitty = false;
  bool sixel = false;
  bool complete = false;  // the last question was answered
  int cell_width = 0;     // 0: not told
  int cell_height = 0;
  std::string rest;
};
Answers read_answers(std::string_view text);

// Whether pictures can be drawn on this descriptor: a terminal that knows colours.
bool draws_pictures(int descriptor);

// Asks, and waits at most `patience` for the answers; a terminal that says nothing gets half blocks. `typed`
// receives what the person typed meanwhile.
TerminalLooks ask_terminal(int input, int output, std::chrono::milliseconds patience, std::string& typed);

WindowSize window_size(int descriptor);

}  // namespace lamella::session
