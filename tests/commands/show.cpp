#include "support/trial.h"

namespace lamella::trial {
namespace {

bool is_png(const std::string& path) {
  return file_content(path).starts_with("\x89PNG");
}

TEST(Show, WritesAPicture) {
  Trial trial("cube.fe");
  const Folder folder;
  trial.out("show " + (folder / "a-b.2.png") + " width 64 height=48 from (1, -2, 0.5) zoom 1.5 samples 1");
  EXPECT_TRUE(is_png(folder / "a-b.2.png"));
  trial.out("name := \"" + (folder / "b.png") + "\"; show name width 32 height 32 transparent");
  EXPECT_TRUE(is_png(folder / "b.png"));
}

TEST(Show, Refuses) {
  Trial trial;
  EXPECT_TRUE(contains(trial.failure("show"), "nothing to show"));
  trial.session().load(datafile("cube.fe"));
  EXPECT_TRUE(contains(trial.failure("show a.png width 0"), "at least 1"));
  EXPECT_TRUE(contains(trial.failure("show a.png from (0, 0, 0)"), "no direction"));
  EXPECT_TRUE(contains(trial.failure("show a.png from (1, 0)"), "takes 3 numbers"));
  EXPECT_TRUE(contains(trial.failure("show a.png widht 5"), "did you mean \"width\"?"));
  EXPECT_FALSE(std::filesystem::exists("a.png"));
}

}  // namespace
}  // namespace lamella::trial
