#include "support/trial.h"

namespace lamella::trial {
namespace {

TEST(Linear, IsAllThereIs) {
  Trial trial("cube.fe");
  trial.session().set_quiet(false);
  EXPECT_EQ(trial.out("M 1"), "Model already LINEAR.\n");
  EXPECT_TRUE(contains(trial.failure("M 2"), "test:1:1: error: model 2 is not supported"));
  EXPECT_TRUE(contains(trial.failure("quadratic"), "quadratic is not supported: facets are flat"));
  EXPECT_TRUE(contains(trial.failure("lagrange 4"), "lagrange is not supported"));
}

}  // namespace
}  // namespace lamella::trial
