#include "picture/terminal_image.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include "picture/page.h"

namespace lamella::picture {

namespace {

using Writer = std::back_insert_iterator<std::string>;

// The steps of a channel in xterm's cube of 6 * 6 * 6 colours, which begins at 16; 24 greys follow it.
constexpr std::array<int, 6> cube_steps = {0, 95, 135, 175, 215, 255};

int nearest_step(int value) {
  int best = 0;
  for (int i = 1; i < 6; ++i) {
    if (std::abs(cube_steps[static_cast<std::size_t>(i)] - value) <
        std::abs(cube_steps[static_cast<std::size_t>(best)] - value))
      best = i;
  }
  return best;
}

int square(int x) {
  return x * x;
}

int palette_number(const Pixel& p) {
  const int r = nearest_step(p.red);
  const int g = nearest_step(p.green);
  const int b = nearest_step(p.blue);
  const auto step = [](int i) { return cube_steps[static_cast<std::size_t>(i)]; };
  const int cube_error = square(step(r) - p.red) + square(step(g) - p.green) + square(step(b) - p.blue);
  const int mean = (p.red + p.green + p.blue) / 3;
  const int grey = std::clamp((mean - 3) / 10, 0, 23);
  const int level = 8 + 10 * grey;
  const int grey_error = square(level - p.red) + square(level - p.green) + square(level - p.blue);
  return grey_error < cube_error ? 232 + grey : 16 + 36 * r + 6 * g + b;
}

void set_colour(Writer out, int layer, const Pixel& p, TerminalColours colours) {
  if (colours == TerminalColours::all) {
    fmt::format_to(out, "\x1b[{}8;2;{};{};{}m", layer, p.red, p.green, p.blue);
  } else {
    fmt::format_to(out, "\x1b[{}8;5;{}m", layer, palette_number(p));
  }
}

}  // namespace

std::string half_blocks(const Image& image, TerminalColours colours) {
  constexpr int text = 3;
  constexpr int ground = 4;
  std::string result;
  const Writer out(result);
  for (int y = 0; y < image.height; y += 2) {
    std::optional<Pixel> upper;
    std::optional<Pixel> lower;
    for (int x = 0; x < image.width; ++x) {
      const Pixel& above = image.at(x, y);
      const Pixel& below = image.at(x, std::min(y + 1, image.height - 1));
      if (upper != above) set_colour(out, text, above, colours);
      if (lower != below) set_colour(out, ground, below, colours);
      upper = above;
      lower = below;
      result += "\u2580";
    }
    result += "\x1b[0m\n";
  }
  return result;
}

namespace {

// Levels of red, green and blue in sixel pictures.
constexpr std::array<int, 3> levels = {6, 7, 6};

struct Dithered {
  std::vector<std::uint8_t> numbers;  // one a pixel
};

// R. W. Floyd and L. Steinberg: what a pixel's colour is wrong by is spread over those that follow.
Dithered dither(const Image& image) {
  Dithered result;
  result.numbers.resize(image.pixels.size());
  const auto width = static_cast<std::size_t>(image.width);
  std::vector<std::array<float, 3>> here(width + 2);
  std::vector<std::array<float, 3>> below(width + 2);
  for (std::size_t y = 0; y < static_cast<std::size_t>(image.height); ++y) {
    for (std::size_t x = 0; x < width; ++x) {
      const Pixel& p = image.pixels[y * width + x];
      const std::array<std::uint8_t, 3> channels = {p.red, p.green, p.blue};
      int number = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        const auto most = static_cast<float>(levels[k] - 1);
        const float wanted = static_cast<float>(channels[k]) + here[x + 1][k];
        const float level = std::round(std::clamp(wanted / 255, 0.0F, 1.0F) * most);
        number = number * levels[k] + static_cast<int>(level);
        const float error = wanted - 255 * level / most;
        here[x + 2][k] += error * 7 / 16;
        below[x][k] += error * 3 / 16;
        below[x + 1][k] += error * 5 / 16;
        below[x + 2][k] += error * 1 / 16;
      }
      result.numbers[y * width + x] = static_cast<std::uint8_t>(number);
    }
    here.swap(below);
    std::fill(below.begin(), below.end(), std::array<float, 3>{});
  }
  return result;
}

// A run of one sixel, counted where that is shorter.
void put_run(std::string& text, char sixel, int length) {
  if (length > 3) {
    fmt::format_to(Writer(text), "!{}{}", length, sixel);
  } else {
    text.append(static_cast<std::size_t>(length), sixel);
  }
}

// Six rows: each colour's pixels in turn, over the same columns.
void put_band(std::string& text, const Image& image, const Dithered& dithered, int top) {
  const auto width = static_cast<std::size_t>(image.width);
  std::array<std::string, 252> rows;
  const int height = std::min(6, image.height - top);
  for (int y = 0; y < height; ++y) {
    for (std::size_t x = 0; x < width; ++x) {
      std::string& row = rows[dithered.numbers[static_cast<std::size_t>(top + y) * width + x]];
      if (row.empty()) row.assign(width, '?');
      row[x] = static_cast<char>('?' + ((row[x] - '?') | 1 << y));
    }
  }
  for (std::size_t colour = 0; colour < rows.size(); ++colour) {
    const std::string& row = rows[colour];
    if (row.empty()) continue;
    fmt::format_to(Writer(text), "#{}", colour);
    for (std::size_t x = 0; x < row.size();) {
      std::size_t end = x;
      while (end < row.size() && row[end] == row[x]) ++end;
      put_run(text, row[x], static_cast<int>(end - x));
      x = end;
    }
    text += '$';
  }
  text += '-';
}

}  // namespace

std::string sixels(const Image& image) {
  std::string text = fmt::format("\x1bP0;1q\"1;1;{};{}", image.width, image.height);
  const Writer out(text);
  for (int number = 0; number < levels[0] * levels[1] * levels[2]; ++number) {
    const auto percent = [](int level, int count) { return 100 * level / (count - 1); };
    fmt::format_to(out, "#{};2;{};{};{}", number, percent(number / (levels[1] * levels[2]), levels[0]),
                   percent(number / levels[2] % levels[1], levels[1]),
                   percent(number % levels[2], levels[2]));
  }
  const Dithered dithered = dither(image);
  for (int top = 0; top < image.height; top += 6) put_band(text, image, dithered, top);
  return text + "\x1b\\";
}

std::string kitty_picture(std::string_view png, int columns, int rows) {
  constexpr std::size_t longest = 4096;
  const std::string data = base64(png);
  std::string text;
  for (std::size_t at = 0; at < data.size(); at += longest) {
    const bool more = at + longest < data.size();
    const std::string keys = at == 0
                                 ? fmt::format("a=T,f=100,q=2,c={},r={},m={}", columns, rows, more ? 1 : 0)
                                 : fmt::format("m={}", more ? 1 : 0);
    text += fmt::format("\x1b_G{};{}\x1b\\", keys, data.substr(at, longest));
  }
  return text;
}

}  // namespace lamella::picture
