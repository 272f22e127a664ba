#include "support/trial.h"

namespace lamella::trial {
namespace {

TEST(Recalc, IsAccepted) {
  Trial trial("cube.fe");
  EXPECT_EQ(trial.out("set vertex x 2*x; recalc; print total_area"), "10\n");
  EXPECT_EQ(trial.out("showq; close_show; whereami; free_discards"), "");
}

}  // namespace
}  // namespace lamella::trial
