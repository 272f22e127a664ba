#include "picture/png.h"

#include <gtest/gtest.h>

#include "picture/decode_png.h"
#include "text/error.h"

namespace lamella::picture {
namespace {

Image pattern(int width, int height, bool opaque) {
  Image image(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      image.at(x, y) = {static_cast<std::uint8_t>(7 * x), static_cast<std::uint8_t>(11 * y),
                        static_cast<std::uint8_t>(x * y),
                        static_cast<std::uint8_t>(opaque ? 255 : 3 * x + y)};
    }
  }
  return image;
}

TEST(Png, DecodesToTheSamePixels) {
  const Image image = pattern(37, 23, true);
  const Decoded decoded = decode_png(encode_png(image));
  EXPECT_EQ(decoded.image.width, 37);
  EXPECT_EQ(decoded.image.height, 23);
  EXPECT_EQ(decoded.image.pixels, image.pixels);
  EXPECT_FALSE(decoded.has_opacity);
}

TEST(Png, KeepsOpacityWhereThereIsAny) {
  const Image image = pattern(40, 9, false);
  const Decoded decoded = decode_png(encode_png(image));
  EXPECT_TRUE(decoded.has_opacity);
  EXPECT_EQ(decoded.image.pixels, image.pixels);
}

TEST(Png, RefusesAnImageWithoutPixels) {
  EXPECT_THROW(encode_png(Image(0, 5)), text::Error);
}

}  // namespace
}  // namespace lamella::picture
