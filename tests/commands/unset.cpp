#include "support/trial.h"

namespace lamella::trial {
namespace {

TEST(Unset, TakesAway) {
  Trial trial("cube.fe");
  EXPECT_EQ(trial.out("set vertex fixed; unset vertex fixed where id > 4; print count(vertex where fixed)"),
            "4\n");
  EXPECT_EQ(trial.out("unset body[1] target; print body[1].volfixed; print body[1].target"), "0\n0\n");
  EXPECT_EQ(trial.out("body[1].pressure := 2; unset body pressure; print body[1].pressure"), "0\n");
  EXPECT_EQ(trial.out("unset facet[1] frontbody; print facet[1].frontbody"), "0\n");
  EXPECT_EQ(trial.out("set facet tension 3; unset facet tension; print facet[1].tension"), "1\n");
}

TEST(Unset, RefusesTheRest) {
  Trial trial("cube.fe");
  EXPECT_TRUE(contains(trial.failure("unset vertex x"), "cannot be unset"));
  EXPECT_TRUE(contains(trial.failure("unset vertex fixed 3"), "takes no value"));
}

}  // namespace
}  // namespace lamella::trial
