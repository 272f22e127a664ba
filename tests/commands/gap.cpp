#include "support/trial.h"

namespace lamella::trial {
namespace {

TEST(Gap, SetsTheConstant) {
  Trial trial("cube.fe");
  trial.out("k 2.5");
  EXPECT_EQ(trial.session().scene().gap_constant, 2.5);
  EXPECT_TRUE(contains(trial.failure("k"), "k needs constant"));
}

}  // namespace
}  // namespace lamella::trial
