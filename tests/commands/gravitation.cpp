#include "support/trial.h"

namespace lamella::trial {
namespace {

TEST(Gravitation, SetsAndTells) {
  Trial trial("cube.fe");
  EXPECT_EQ(trial.out("G 3"), "Gravity is ON with gravitational constant 3.000000. (was on)\n");
  EXPECT_EQ(trial.number("gravity_constant"), 3);
  EXPECT_EQ(trial.out("G 0"), "Gravity is OFF with gravitational constant 0.000000. (was on)\n");
  EXPECT_EQ(trial.number("gravity"), 0);
  EXPECT_EQ(trial.out("G"), "Gravity is OFF with gravitational constant 0.000000. (was off)\n");
}

}  // namespace
}  // namespace lamella::trial
