#include <cmath>

#include "support/trial.h"

namespace lamella::trial {
namespace {

TEST(Volumes, PrintsEvolversRows) {
  Trial trial("cube.fe");
  EXPECT_EQ(trial.out("v"),
            "Body          target volume           actual volume          pressure\n"
            "  1                       1                       1                 0\n");
  EXPECT_EQ(trial.out("unset body[1] target; set vertex z 2 where z == 1; show_vol"),
            "Body          target volume           actual volume          pressure\n"
            "  1            ------------                       2                 0\n");
  EXPECT_EQ(trial.out("body[1].pressure := 1.25; volumes"),
            "Body          target volume           actual volume          pressure\n"
            "  1            ------------                       2              1.25\n");
}

TEST(Volumes, SaysWhenThereAreNone) {
  EXPECT_EQ(Trial("catenoid.fe").out("v"), "No bodies.\n");
  EXPECT_EQ(Trial().out("v"), "No bodies.\n");
  EXPECT_TRUE(contains(Trial("cube.fe").failure("v 1"), "v takes no arguments"));
}

// The pressure of a round bubble is 2 sigma H = 2/R.
TEST(Volumes, PressureIsTheOneOfTheLastSolve) {
  Trial trial("cube.fe");
  trial.out("refine 4; relax");
  EXPECT_NEAR(trial.number("body[1].pressure"), 2 / std::cbrt(3 / (4 * M_PI)), 0.01);
}

}  // namespace
}  // namespace lamella::trial
