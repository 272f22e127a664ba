#include "support/trial.h"

namespace lamella::trial {
namespace {

// More in tests/session/undo.cpp.
TEST(UndoCommand, TakesACount) {
  Trial trial("cube.fe");
  trial.out("x := 1; x := 2; x := 3; undo 2");
  EXPECT_EQ(trial.number("x"), 1);
  EXPECT_TRUE(contains(trial.failure("undo 5"), "only 1 steps"));
  EXPECT_TRUE(contains(trial.failure("undo 0"), "at least 1"));
}

}  // namespace
}  // namespace lamella::trial
