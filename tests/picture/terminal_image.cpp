#include "picture/terminal_image.h"

#include <gtest/gtest.h>

#include "picture/page.h"

namespace lamella::picture {
namespace {

Image small() {
  Image image(2, 2);
  image.at(0, 0) = {255, 0, 0, 255};
  image.at(1, 0) = {255, 0, 0, 255};
  image.at(0, 1) = {0, 0, 255, 255};
  image.at(1, 1) = {0, 255, 0, 255};
  return image;
}

TEST(TerminalImage, HalfBlocksShowTwoRowsALine) {
  EXPECT_EQ(half_blocks(small(), TerminalColours::all),
            "\x1b[38;2;255;0;0m\x1b[48;2;0;0;255m\u2580\x1b[48;2;0;255;0m\u2580\x1b[0m\n");
  EXPECT_EQ(half_blocks(small(), TerminalColours::palette),
            "\x1b[38;5;196m\x1b[48;5;21m\u2580\x1b[48;5;46m\u2580\x1b[0m\n");
}

TEST(TerminalImage, GreysOfThePaletteAreUsed) {
  Image image(1, 2);
  image.at(0, 0) = {128, 128, 128, 255};
  image.at(0, 1) = {18, 18, 18, 255};
  EXPECT_EQ(half_blocks(image, TerminalColours::palette), "\x1b[38;5;244m\x1b[48;5;233m\u2580\x1b[0m\n");
}

TEST(TerminalImage, AnOddRowStandsOnItself) {
  Image image(1, 3);
  const std::string text = half_blocks(image, TerminalColours::all);
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 2);
}

// The colours of each pixel of a sixel picture, decoded by the rules of the format.
Image decoded(const std::string& text) {
  Image image;
  std::map<int, Pixel> colours;
  std::size_t at = text.find('q') + 1;
  const auto numbers = [&] {
    std::vector<int> list = {0};
    for (; at < text.size() && (std::isdigit(static_cast<unsigned char>(text[at])) != 0 || text[at] == ';');
         ++at) {
      if (text[at] == ';') {
        list.push_back(0);
      } else {
        list.back() = 10 * list.back() + (text[at] - '0');
      }
    }
    return list;
  };
  int x = 0;
  int y = 0;
  Pixel pen;
  while (at < text.size() && text[at] != '\x1b') {
    const char c = text[at++];
    int repeat = 1;
    char sixel = c;
    if (c == '"') {
      const std::vector<int> raster = numbers();
      image = Image(raster.at(2), raster.at(3));
    } else if (c == '#') {
      const std::vector<int> list = numbers();
      const auto byte = [&](std::size_t i) { return static_cast<std::uint8_t>(list[i] * 255 / 100); };
      if (list.size() == 5) colours[list[0]] = {byte(2), byte(3), byte(4), 255};
      pen = colours.at(list[0]);
      continue;
    } else if (c == '$') {
      x = 0;
    } else if (c == '-') {
      x = 0;
      y += 6;
    } else if (c == '!') {
      repeat = numbers()[0];
      sixel = text[at++];
    }
    if (sixel < '?' || sixel > '~') continue;
    for (; repeat > 0; --repeat, ++x) {
      for (int k = 0; k < 6; ++k) {
        if (((sixel - '?') >> k & 1) != 0) image.at(x, y + k) = pen;
      }
    }
  }
  return image;
}

TEST(TerminalImage, SixelsShowThePicture) {
  Image image(24, 20);
  for (int y = 0; y < 20; ++y) {
    for (int x = 0; x < 24; ++x)
      image.at(x, y) = {static_cast<std::uint8_t>(10 * x), static_cast<std::uint8_t>(12 * y), 90, 255};
  }
  const Image seen = decoded(sixels(image));
  ASSERT_EQ(seen.width, 24);
  ASSERT_EQ(seen.height, 20);
  // Single pixels are rounded to few colours; means are right.
  for (int y = 4; y + 4 < 20; y += 4) {
    for (int x = 4; x + 4 < 24; x += 4) {
      double red = 0;
      double blue = 0;
      for (int k = 0; k < 16; ++k) {
        red += (seen.at(x + k % 4, y + k / 4).red - image.at(x + k % 4, y + k / 4).red) / 16.0;
        blue += (seen.at(x + k % 4, y + k / 4).blue - 90) / 16.0;
      }
      EXPECT_NEAR(red, 0, 16) << x << " " << y;
      EXPECT_NEAR(blue, 0, 16) << x << " " << y;
    }
  }
}

TEST(TerminalImage, KittyTakesPieces) {
  const std::string png(7000, 'x');
  const std::string text = kitty_picture(png, 40, 12);
  EXPECT_TRUE(text.starts_with("\x1b_Ga=T,f=100,q=2,c=40,r=12,m=1;"));
  std::string data;
  int pieces = 0;
  for (std::size_t at = text.find(';'); at != std::string::npos; at = text.find(';', at + 1)) {
    data += text.substr(at + 1, text.find('\x1b', at) - at - 1);
    ++pieces;
  }
  EXPECT_EQ(pieces, 3);
  EXPECT_EQ(data, base64(png));
  EXPECT_NE(text.rfind("m=0;"), std::string::npos);
}

}  // namespace
}  // namespace lamella::picture
