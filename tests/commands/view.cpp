#include "support/trial.h"

namespace lamella::trial {
namespace {

TEST(View, StaysForPicturesToCome) {
  Trial trial("cube.fe");
  trial.out("view top zoom 2");
  EXPECT_TRUE(contains(trial.out("view"), "from (0, 0, 1) zoom 2 pan (0, 0) lens 26"));
  trial.out("view zoom 1.5 pan (0.1, -0.2)");
  EXPECT_TRUE(contains(trial.out("view"), "zoom 3 pan (0.1, -0.2)"));
  trial.out("view fit lens 0");
  EXPECT_TRUE(contains(trial.out("view"), "zoom 1 pan (0, 0) lens 0"));
  trial.out("view from (1, 0, 0)");
  EXPECT_TRUE(contains(trial.out("view"), "from (1, 0, "));
}

// What is turned to the right comes round from the front to the right.
TEST(View, Rotates) {
  Trial trial("cube.fe");
  trial.out("view front");
  trial.out("view rotate (90, 0, 0)");
  EXPECT_TRUE(contains(trial.out("view"), "from (-1, "));
  trial.out("view front rotate (0, 90, 0)");
  EXPECT_TRUE(contains(trial.out("view"), ", -1) zoom"));
}

TEST(View, IsSavedAndLoaded) {
  Trial trial("cube.fe");
  const Folder folder;
  trial.out("view from (1, 2, 3) zoom 1.25 pan (0.5, 0) save \"" + (folder / "v") + "\"");
  const std::string there = trial.out("view");
  trial.out("view reset");
  EXPECT_NE(trial.out("view"), there);
  trial.out("view load \"" + (folder / "v") + "\"");
  EXPECT_EQ(trial.out("view"), there);
  trial.out("view reset; show \"" + (folder / "a.png") + "\" size=20 view=" + (folder / "v"));
  trial.out("view load \"" + (folder / "v") + "\"; show \"" + (folder / "b.png") + "\" size=20");
  EXPECT_EQ(file_content(folder / "a.png"), file_content(folder / "b.png"));
}

TEST(View, Refuses) {
  Trial trial("cube.fe");
  const Folder folder;
  EXPECT_TRUE(contains(trial.failure("view tpo"), "did you mean \"top\"?"));
  EXPECT_TRUE(contains(trial.failure("view zoom 0"), "greater than 0"));
  EXPECT_TRUE(contains(trial.failure("view load /no/such/view"), "/no/such/view"));
  EXPECT_TRUE(
      contains(trial.failure("view load \"" + folder.write("v", "something") + "\""), "no saved view"));
}

}  // namespace
}  // namespace lamella::trial
