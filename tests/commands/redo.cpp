#include "support/trial.h"

namespace lamella::trial {
namespace {

TEST(RedoCommand, TakesACount) {
  Trial trial("cube.fe");
  trial.out("x := 1; x := 2; x := 3; undo 3; redo 2");
  EXPECT_EQ(trial.number("x"), 2);
  EXPECT_TRUE(contains(trial.failure("redo 2"), "only 1 steps"));
}

}  // namespace
}  // namespace lamella::trial
