// Shadows on the ground.
#include <gtest/gtest.h>

#include "picture/scenes.h"
#include "picture/show.h"

namespace lamella::picture {
namespace {

int brightness(const Pixel& p) {
  return p.red + p.green + p.blue;
}

// The film dims nothing but the ground near it; far away the background is as it was.
TEST(Shadow, DimsTheGroundUnderAScene) {
  const scene::Scene scene = scenes::double_bubble(10, 0.7);
  PictureOptions options;
  options.width = 160;
  options.height = 120;
  options.samples = 1;
  const Image plain = render(scene, options);
  options.shadow = true;
  const Image shaded = render(scene, options);
  int dimmer = 0;
  int brighter = 0;
  for (int y = 0; y < 120; ++y) {
    for (int x = 0; x < 160; ++x) {
      const int change = brightness(shaded.at(x, y)) - brightness(plain.at(x, y));
      dimmer += change < -6 ? 1 : 0;
      brighter += change > 3 ? 1 : 0;
    }
  }
  EXPECT_GT(dimmer, 200);
  EXPECT_EQ(brighter, 0);
  EXPECT_EQ(brightness(shaded.at(1, 1)), brightness(plain.at(1, 1)));
}

}  // namespace
}  // namespace lamella::picture
