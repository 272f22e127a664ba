#include "support/trial.h"

namespace lamella::trial {
namespace {

TEST(ShowExpr, FiltersPictures) {
  Trial trial("cube.fe");
  const Folder folder;
  const std::string all = folder / "all.png";
  const std::string some = folder / "some.png";
  trial.out("show \"" + all + "\" size=64");
  trial.out("show_expr facets where (z > 0.1) and (area > 0)");
  trial.out("show \"" + some + "\" size=64");
  EXPECT_NE(file_content(all), file_content(some));
  trial.out("show_expr edges where valence == 3");
  trial.out("show_expr facets; show \"" + some + "\" size=64");
  EXPECT_EQ(file_content(all), file_content(some));
}

// It speaks of the film as it is when a picture is drawn.
TEST(ShowExpr, IsAskedWhenDrawing) {
  Trial trial("cube.fe");
  const Folder folder;
  trial.out("limit := 5; show_expr facets where area > limit");
  EXPECT_TRUE(contains(trial.failure("show \"" + (folder / "none.png") + "\""), "there is nothing to draw"));
  trial.out("limit := 0; r; show \"" + (folder / "some.png") + "\" size=64");
}

}  // namespace
}  // namespace lamella::trial
