#include "support/trial.h"

namespace lamella::trial {
namespace {

// Along normals a film of 9 inner vertices in a plane has 9 modes, in space 27.
TEST(HessianNormal, DecidesHowManyModesThereAre) {
  Trial trial("cube.fe");
  trial.session().set_quiet(false);
  EXPECT_TRUE(contains(trial.out("eigenprobe 1e9"), "13 <,  0 ==,  0 > "));
  EXPECT_EQ(trial.out("hessian_normal off"), "hessian_normal OFF. (was on)\n");
  EXPECT_TRUE(contains(trial.out("eigenprobe 1e9"), "41 <,  0 ==,  0 > "));
  EXPECT_EQ(trial.out("hessian_normal"), "hessian_normal  ON. (was off)\n");
  EXPECT_EQ(trial.out("hessian_normal"), "hessian_normal  ON. (was on)\n");
  EXPECT_TRUE(contains(trial.failure("hessian_normal maybe"), "does not take"));
}

}  // namespace
}  // namespace lamella::trial
