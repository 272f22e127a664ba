#include "support/trial.h"

namespace lamella::trial {
namespace {

TEST(Targets, TakesWhatThereIs) {
  Trial trial("double_bubble.fe");
  trial.out("set vertex z 1.1*z; N");
  EXPECT_EQ(trial.number("body[1].target"), trial.number("body[1].volume"));
  EXPECT_EQ(trial.number("body[2].target"), trial.number("body[2].volume"));
  EXPECT_NE(trial.number("body[1].target"), 1);
}

TEST(Targets, FixesNothing) {
  Trial trial("cube.fe");
  trial.out("unset body[1] target; targets");
  EXPECT_EQ(trial.number("body[1].volfixed"), 0);
}

}  // namespace
}  // namespace lamella::trial
