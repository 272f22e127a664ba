// Each style's picture as it was when people looked at it and were pleased. After a change that is meant, the
// pictures are made anew by LAMELLA_NEW_GOLDEN=1 build/tests/test_picture --gtest_filter='Golden*', and
// looked at.
#include <cmath>
#include <cstdlib>
#include <filesystem>

#include <gtest/gtest.h>

#include "picture/decode_png.h"
#include "picture/png.h"
#include "picture/scenes.h"
#include "picture/show.h"
#include "picture/styles.h"
#include "text/whole_file.h"

namespace lamella::picture {
namespace {

// CIE L*a*b*: equal distances look about equally large, 2.3 is just seen.
using Lab = std::array<double, 3>;

double linear(std::uint8_t byte) {
  const double v = byte / 255.0;
  return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
}

Lab lab(const Pixel& p) {
  const double r = linear(p.red);
  const double g = linear(p.green);
  const double b = linear(p.blue);
  const auto f = [](double t) { return t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16.0 / 116; };
  const double x = f((0.4124 * r + 0.3576 * g + 0.1805 * b) / 0.9505);
  const double y = f(0.2126 * r + 0.7152 * g + 0.0722 * b);
  const double z = f((0.0193 * r + 0.1192 * g + 0.9505 * b) / 1.089);
  return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

// Means over 4 by 4 pixels: an edge that falls a little differently between pixels does not count.
std::vector<Lab> blocks(const Image& image) {
  std::vector<Lab> result;
  for (int y = 0; y + 4 <= image.height; y += 4) {
    for (int x = 0; x + 4 <= image.width; x += 4) {
      Lab sum{};
      for (int k = 0; k < 16; ++k) {
        const Lab one = lab(image.at(x + k % 4, y + k / 4));
        for (std::size_t i = 0; i < 3; ++i) sum[i] += one[i] / 16;
      }
      result.push_back(sum);
    }
  }
  return result;
}

struct Difference {
  double mean = 0;
  double largest = 0;
};

Difference difference(const Image& a, const Image& b) {
  const std::vector<Lab> one = blocks(a);
  const std::vector<Lab> other = blocks(b);
  Difference d;
  for (std::size_t i = 0; i < one.size(); ++i) {
    const double distance =
        std::hypot(one[i][0] - other[i][0], one[i][1] - other[i][1], one[i][2] - other[i][2]);
    d.mean += distance / static_cast<double>(one.size());
    d.largest = std::max(d.largest, distance);
  }
  return d;
}

Image picture(const std::string& style) {
  scene::Scene scene = scenes::double_bubble(10, 0.75);
  scene.bodies.resize(2);
  PictureOptions options;
  options.width = 160;
  options.height = 120;
  options.style = style_named(style);
  return render(scene, options);
}

class Golden : public ::testing::TestWithParam<std::string> {};

TEST_P(Golden, LooksAsItDid) {
  const std::string path = std::string(LAMELLA_SOURCE_DIR) + "/tests/picture/golden/" + GetParam() + ".png";
  const Image now = picture(GetParam());
  if (std::getenv("LAMELLA_NEW_GOLDEN") != nullptr) text::write_whole_file(path, encode_png(now));
  const Image then = decode_png(text::read_whole_file(path)).image;
  ASSERT_EQ(now.width, then.width);
  ASSERT_EQ(now.height, then.height);
  const Difference d = difference(now, then);
  EXPECT_LT(d.mean, 0.5);
  EXPECT_LT(d.largest, 6);
}

// The measure itself: another style is far off, noise that nobody sees is not.
TEST(GoldenMeasure, SeesWhatPeopleSee) {
  const Image film = picture("film");
  EXPECT_GT(difference(film, picture("regions")).mean, 2);
  Image noisy = film;
  for (std::size_t i = 0; i < noisy.pixels.size(); i += 3) noisy.pixels[i].green ^= 1U;
  EXPECT_LT(difference(film, noisy).mean, 0.5);
}

INSTANTIATE_TEST_SUITE_P(Styles, Golden, ::testing::ValuesIn(style_names()),
                         [](const auto& each) { return each.param; });

}  // namespace
}  // namespace lamella::picture
