#include "support/trial.h"

namespace lamella::trial {
namespace {

TEST(Abort, TakesBackWhatRan) {
  Trial trial("cube.fe");
  EXPECT_TRUE(contains(trial.failure("if total_area > 5 then { r; abort }"), "aborted"));
  EXPECT_EQ(trial.number("facet_count"), 24);
}

}  // namespace
}  // namespace lamella::trial
