#include "support/trial.h"

namespace lamella::trial {
namespace {

TEST(FixScale, FixesAndFreesTheStepOfG) {
  Trial trial("cube.fe");
  trial.session().set_quiet(false);
  EXPECT_EQ(trial.out("m 0.05"), "Scale fixed at 0.05.\n");
  EXPECT_EQ(trial.number("scale"), 0.05);
  EXPECT_TRUE(contains(trial.out("g"), "  scale: 0.0500000\n"));
  EXPECT_TRUE(contains(trial.out("g"), "  scale: 0.0500000\n"));
  EXPECT_EQ(trial.out("fix_scale"), "Scale optimizing.\n");
  EXPECT_FALSE(contains(trial.out("g"), "  scale: 0.0500000\n"));
  EXPECT_EQ(trial.out("m 0.1; m; m"), "Scale fixed at 0.1.\nScale optimizing.\nScale fixed at 0.1.\n");
}

TEST(FixScale, Refuses) {
  Trial trial("cube.fe");
  EXPECT_TRUE(contains(trial.failure("m 0"), "test:1:3: error: scale must be greater than 0, not 0"));
  EXPECT_TRUE(contains(trial.failure("m -0.1"), "scale must be greater than 0"));
  EXPECT_TRUE(contains(trial.failure("m fast"), "m does not take \"fast\" here"));
  EXPECT_EQ(trial.number("scale"), 0.1);
}

}  // namespace
}  // namespace lamella::trial
