#include "support/trial.h"

namespace lamella::trial {
namespace {

TEST(ConjGrad, IsTurnedAround) {
  Trial trial("cube.fe");
  trial.session().set_quiet(false);
  EXPECT_EQ(trial.out("U"), "Conjugate gradient now ON. (was off)\n");
  EXPECT_EQ(trial.out("U"), "Conjugate gradient now OFF. (was on)\n");
  EXPECT_EQ(trial.out("conj_grad on"), "Conjugate gradient now ON. (was off)\n");
  EXPECT_EQ(trial.out("conj_grad on"), "Conjugate gradient now ON. (was on)\n");
}

// What it is for: it gets nearer in as many steps.
TEST(ConjGrad, GetsFartherThanSteepestDescent) {
  Trial trial("wire_cube.fe");
  trial.out("refine 3; g 40");
  const double steepest = trial.number("total_energy");
  trial.out("undo; U; g 40");
  const double conjugate = trial.number("total_energy");
  EXPECT_LT(conjugate, steepest - 1e-5);
  EXPECT_GT(conjugate, 4.2395);
}

TEST(ConjGrad, KeepsVolumes) {
  Trial trial("double_bubble.fe");
  trial.out("refine 2; U; g 30");
  EXPECT_NEAR(trial.number("body[1].volume"), 1, 1e-12);
  EXPECT_NEAR(trial.number("body[2].volume"), 1, 1e-12);
  EXPECT_LT(trial.number("total_energy"), 9.2);
}

}  // namespace
}  // namespace lamella::trial
