#include <cmath>

#include "support/trial.h"

namespace lamella::trial {
namespace {

// Width and order of the numbers are Evolver's: "%3d. area: %#17.15g energy: %#17.15g  scale: %#g".
TEST(G, CountsDownInEvolversRows) {
  Trial trial("cube.fe");
  trial.session().set_quiet(false);
  trial.out("refine");
  const std::string rows = trial.out("g 2");
  EXPECT_TRUE(contains(rows, "  2. area:  5."));
  EXPECT_TRUE(contains(rows, "\n  1. area:  4."));
  const std::string row = rows.substr(0, rows.find('\n'));
  EXPECT_EQ(row.find(" energy: "), 28U) << row;
  EXPECT_EQ(row.find("  scale: "), 54U) << row;
  EXPECT_EQ(trial.out("g 0"), "");
}

// The volume is kept exactly; the area falls with every step; Evolver needs about as many steps.
TEST(G, DescendsWithExactVolumes) {
  Trial trial("cube.fe");
  trial.out("refine 2");
  double before = trial.number("total_area");
  for (int i = 0; i < 20; ++i) {
    trial.out("g");
    const double area = trial.number("total_area");
    EXPECT_LT(area, before);
    EXPECT_NEAR(trial.number("body[1].volume"), 1, 1e-12);
    before = area;
  }
  EXPECT_LT(before, 4.95);
  EXPECT_NEAR(trial.number("body[1].pressure"), 2 / std::cbrt(3 / (4 * M_PI)), 0.2);
}

// Surface Evolver 2.70 has these areas after `r; g 5`. Its volumes lag behind a little, ours do not.
TEST(G, GoesAsFarAsEvolver) {
  const std::pair<const char*, double> areas[] = {{"cube.fe", 4.92088508312789},
                                                  {"double_bubble.fe", 9.26253991145811},
                                                  {"catenoid.fe", 7.86898075997175},
                                                  {"wire_cube.fe", 4.24179359839291}};
  for (const auto& [file, area] : areas) {
    Trial trial(file);
    trial.out("r; g 5");
    EXPECT_NEAR(trial.number("total_area"), area, 2e-4 * area) << file;
  }
}

TEST(G, LeavesFixedVertices) {
  Trial trial("catenoid.fe");
  const std::string before = trial.out("refine; list vertices where fixed");
  EXPECT_EQ(trial.out("g 10; list vertices where fixed"), before);
}

TEST(G, EndsWhereNothingLowersTheEnergy) {
  Trial trial("cube.fe");
  trial.session().set_quiet(false);
  EXPECT_TRUE(contains(trial.out("fix vertex; vc off; g 10"),
                       "No step along the gradient lowers the energy any more."));
  EXPECT_EQ(trial.number("total_area"), 6);
}

TEST(G, Refuses) {
  Trial trial("cube.fe");
  EXPECT_TRUE(contains(trial.failure("g -1"), "test:1:3: error: steps must be at least 0, not -1"));
  EXPECT_TRUE(contains(trial.failure("g 0.5"), "steps must be a whole number, not 0.5"));
  EXPECT_TRUE(contains(trial.failure("g 1e20"), "steps must be a whole number"));
  EXPECT_TRUE(contains(trial.failure("{ fix vertex; body[1].target := 2; g }"),
                       "cannot be brought to their targets"));
  EXPECT_TRUE(contains(Trial().failure("g"), "there is no film to move"));
  EXPECT_EQ(trial.number("total_area"), 6);
}

}  // namespace
}  // namespace lamella::trial
