#include "support/trial.h"

namespace lamella::trial {
namespace {

TEST(Exec, RunsAString) {
  Trial trial("cube.fe");
  EXPECT_EQ(trial.out("exec \"print 3; print 4\""), "3\n4\n");
  EXPECT_EQ(trial.out("exec sprintf(\"made := %d\", 7); print made"), "7\n");
}

TEST(Exec, TellsWhereItFails) {
  Trial trial("cube.fe");
  EXPECT_TRUE(
      contains(trial.failure("exec \"r; nonsense\""), "exec:1:4: error: there is no command \"nonsense\""));
  EXPECT_EQ(trial.number("facet_count"), 24);
}

}  // namespace
}  // namespace lamella::trial
