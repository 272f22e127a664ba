#include "support/trial.h"

namespace lamella::trial {
namespace {

// On a sphere of radius R the windward half is pushed by the integral of (u.n)^2 n-component: u p times a
// third of its area along the wind.
TEST(Wind, PushesTheWindwardSide) {
  Trial trial("cube.fe");
  trial.out("refine 4; relax; wind (0, 0, 1) pressure 0.5; evolve 1 dt 1e-5");
  const double area = trial.number("total_area");
  EXPECT_NEAR(trial.number("momentum_z"), 1e-5 * 0.5 * area / 2 / 3, 1e-5 * 0.5 * area / 6 * 0.02);
  EXPECT_NEAR(trial.number("momentum_x"), 0, 1e-9);
}

// A bubble in a steady wind goes with it in the end, and no faster.
TEST(Wind, IsRelativeToTheFilm) {
  Trial trial("cube.fe");
  trial.out("refine 2; relax; set vertices velocity[1] 1; wind (1, 0, 0); evolve 50");
  EXPECT_NEAR(trial.number("momentum_x") / trial.number("sum(vertices, mass)"), 1, 1e-9);
}

TEST(Wind, IsPrintedAndTurnedOff) {
  Trial trial("cube.fe");
  EXPECT_EQ(trial.out("wind"), "wind off\n");
  trial.out("wind (0, 1, z) pressure 2");
  EXPECT_EQ(trial.out("wind"), "wind (0, 1, z) pressure 2\n");
  trial.out("wind off");
  EXPECT_EQ(trial.out("wind"), "wind off\n");
  EXPECT_TRUE(contains(trial.failure("wind (0, 0, 1) pressure -1"), "at least 0"));
}

}  // namespace
}  // namespace lamella::trial
