#include "picture/page.h"

#include <array>
#include <cstdio>
#include <filesystem>

#include <gtest/gtest.h>
#include <unistd.h>

#include "picture/decode_png.h"
#include "picture/scenes.h"
#include "picture/show.h"
#include "text/whole_file.h"

namespace lamella::picture {
namespace {

TEST(Page, Base64) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(base64("\xff\xfe\xfd"), "//79");
}

std::string page() {
  scene::Scene scene = scenes::double_bubble(5, 1);
  scene.bodies.resize(2);
  scene.name = "a<b&.fe";
  return encode_picture(scene, FileKind::html, PictureOptions{});
}

TEST(Page, StandsAlone) {
  const std::string text = page();
  EXPECT_EQ(text.find("http"), std::string::npos);
  EXPECT_EQ(text.find("src="), std::string::npos);
  EXPECT_EQ(text.find("@frames@"), std::string::npos);
  EXPECT_NE(text.find("<title>a&lt;b&amp;.fe</title>"), std::string::npos);
}

// A browser without a window takes a picture of the page.
TEST(Page, IsDrawnByABrowser) {
  if (std::system("chromium --version >/dev/null 2>&1") != 0) GTEST_SKIP() << "chromium is not installed";
  const auto folder = std::filesystem::temp_directory_path() / ("lamella-page-" + std::to_string(::getpid()));
  std::filesystem::create_directory(folder);
  text::write_whole_file(folder / "page.html", page());
  const std::string command =
      "cd '" + folder.string() +
      "' && timeout 120 chromium --headless --no-sandbox --use-gl=angle --use-angle=swiftshader "
      "--enable-unsafe-swiftshader --user-data-dir=profile --window-size=400,300 --screenshot=page.png "
      "--virtual-time-budget=4000 page.html >log 2>&1";
  const int status = std::system(command.c_str());
  const bool taken = status == 0 && std::filesystem::exists(folder / "page.png");
  const Image image = taken ? decode_png(text::read_whole_file(folder / "page.png")).image : Image();
  std::filesystem::remove_all(folder);
  if (!taken) GTEST_SKIP() << "chromium does not run here";
  // The bubbles stand in the middle, before the gradient, which alone is seen at the right edge.
  int drawn = 0;
  for (int y = image.height / 4; y < 3 * image.height / 4; ++y) {
    const Pixel behind = image.at(image.width - 2, y);
    for (int x = image.width / 3; x < 2 * image.width / 3; ++x)
      drawn += std::abs(image.at(x, y).green - behind.green) > 4 ? 1 : 0;
  }
  EXPECT_GT(drawn, image.width * image.height / 6 / 4);
}

}  // namespace
}  // namespace lamella::picture
