#include "picture/blending.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "picture/colour.h"
#include "picture/development.h"

namespace lamella::picture {
namespace {

// As the shader packs it, from tenths of the full range.
Fragment fragment(float depth, int red, int green, int blue, int clear) {
  const auto bits = [](int tenths) { return static_cast<std::uint32_t>(tenths * 1023 / 10); };
  return {depth, Fragment::end_of_list, bits(red) | bits(green) << 10 | bits(blue) << 20,
          bits(clear) | bits(clear) << 10 | bits(clear) << 20};
}

Layer blend_all(std::vector<Fragment> fragments) {
  for (std::size_t i = 0; i + 1 < fragments.size(); ++i)
    fragments[i].next = static_cast<std::uint32_t>(i + 1);
  return Blender().blend(fragments, fragments.empty() ? Fragment::end_of_list : 0);
}

void expect_same(const Layer& a, const Layer& b) {
  EXPECT_EQ(a.glow.red, b.glow.red);
  EXPECT_EQ(a.glow.green, b.glow.green);
  EXPECT_EQ(a.glow.blue, b.glow.blue);
  EXPECT_EQ(a.clear.red, b.clear.red);
}

TEST(Blending, NoFilmIsClear) {
  expect_same(blend_all({}), Layer{});
}

TEST(Blending, GlowIsPackedAsARoot) {
  const Layer layer = unpack(fragment(1, 5, 10, 0, 5));
  EXPECT_NEAR(layer.glow.red, 1.0, 0.01);
  EXPECT_FLOAT_EQ(layer.glow.green, 4.0F);
  EXPECT_FLOAT_EQ(layer.glow.blue, 0.0F);
  EXPECT_NEAR(layer.clear.red, 0.5, 0.001);
}

TEST(Blending, TheNearerFilmHidesTheFartherOne) {
  const Fragment near = fragment(1, 5, 0, 0, 2);
  const Fragment far = fragment(2, 0, 5, 0, 8);
  const Layer a = unpack(near);
  const Layer b = unpack(far);
  const Layer seen = blend_all({far, near});
  EXPECT_FLOAT_EQ(seen.glow.red, a.glow.red);
  EXPECT_FLOAT_EQ(seen.glow.green, a.clear.green * b.glow.green);
  EXPECT_FLOAT_EQ(seen.clear.blue, a.clear.blue * b.clear.blue);
}

TEST(Blending, TheOrderOfTheListDoesNotMatter) {
  std::vector<Fragment> fragments;
  for (int i = 0; i < 6; ++i)
    fragments.push_back(fragment(static_cast<float>(i / 2), i, 6 - i, (3 * i) % 7, 4 + i % 3));
  const Layer expected = blend_all(fragments);
  std::vector<int> order = {0, 1, 2, 3, 4, 5};
  do {
    std::vector<Fragment> shuffled;
    for (const int i : order) shuffled.push_back(fragments[static_cast<std::size_t>(i)]);
    expect_same(blend_all(shuffled), expected);
  } while (std::next_permutation(order.begin(), order.end()));
}

TEST(Colour, BytesOfSrgbComeBack) {
  for (std::uint32_t byte = 0; byte < 256; ++byte) EXPECT_EQ(srgb_byte(srgb(byte << 8).green), byte);
  EXPECT_EQ(srgb_byte(-1.0F), 0);
  EXPECT_EQ(srgb_byte(7.0F), 255);
}

TEST(Development, OffsetsShareNoRowAndNoColumn) {
  for (const int count : {1, 2, 4, 5, 8, 13}) {
    std::vector<int> rows(static_cast<std::size_t>(count), 0);
    std::vector<int> columns(static_cast<std::size_t>(count), 0);
    for (const Offset& offset : sample_offsets(count)) {
      ++columns.at(static_cast<std::size_t>(std::lround((offset.right + 0.5) * count - 0.5)));
      ++rows.at(static_cast<std::size_t>(std::lround((offset.down + 0.5) * count - 0.5)));
    }
    EXPECT_EQ(rows, std::vector<int>(static_cast<std::size_t>(count), 1)) << count;
    EXPECT_EQ(columns, rows) << count;
  }
}

}  // namespace
}  // namespace lamella::picture
