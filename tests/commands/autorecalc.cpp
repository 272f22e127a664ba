#include "support/trial.h"

namespace lamella::trial {
namespace {

TEST(Autorecalc, IsAcceptedAndChangesNothing) {
  Trial trial("cube.fe");
  EXPECT_EQ(trial.out("autorecalc on; gv_binary off; metric_conversion off; autodisplay"), "");
  EXPECT_TRUE(contains(trial.failure("undo"), "nothing to undo"));
  EXPECT_TRUE(contains(trial.failure("autorecalc maybe"), "does not take"));
}

}  // namespace
}  // namespace lamella::trial
