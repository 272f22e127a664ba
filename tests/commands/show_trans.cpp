#include "support/trial.h"

namespace lamella::trial {
namespace {

TEST(ShowTrans, IsAccepted) {
  Trial trial("cube.fe");
  EXPECT_EQ(trial.out("show_trans \"rrd\""), "");
  EXPECT_TRUE(contains(trial.failure("show_trans"), "show_trans needs keys"));
}

}  // namespace
}  // namespace lamella::trial
