#include <cmath>

#include "support/trial.h"

namespace lamella::trial {
namespace {

// (l - 1)(l + 2)/R^2 with 2l + 1 modes each.
TEST(Eigen, PrintsTheModesOfABubble) {
  Trial trial("cube.fe");
  const std::string out = trial.out("refine 4; relax; eigen 9");
  std::istringstream lines(out);
  std::string line;
  const double radius = std::cbrt(3 / (4 * M_PI));
  for (int i = 1; std::getline(lines, line); ++i) {
    int number = 0;
    double value = 0;
    ASSERT_EQ(std::sscanf(line.c_str(), "%d. %lf", &number, &value), 2) << line;
    EXPECT_EQ(number, i);
    const double exact = (i <= 3 ? 0 : i <= 8 ? 4 : 10) / (radius * radius);
    EXPECT_NEAR(value, exact, 0.02 * exact + 0.05) << line;
    EXPECT_EQ(contains(line, "motion of the film as a whole"), i <= 3) << line;
  }
  EXPECT_NEAR(trial.number("last_eigenvalue"), 0, 0.05);
}

TEST(Eigen, DrawsAMode) {
  const Folder folder;
  Trial trial("cube.fe");
  trial.out("refine 2; relax; eigen show 4 \"" + (folder / "mode.png") + "\"");
  EXPECT_GT(file_content(folder / "mode.png").size(), 1000U);
  EXPECT_TRUE(
      contains(trial.failure("eigen show 400 \"" + (folder / "mode.png") + "\""), "there is no mode 400"));
}

TEST(Eigen, Refuses) {
  Trial trial("cube.fe");
  EXPECT_TRUE(contains(trial.failure("eigen 0"), "count must be at least 1"));
  EXPECT_TRUE(contains(trial.failure("fix vertex; vc off; eigen"), "no modes that could be found"));
  EXPECT_TRUE(contains(Trial().failure("eigen"), "there is no film"));
}

}  // namespace
}  // namespace lamella::trial
