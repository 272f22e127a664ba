#include "support/trial.h"

namespace lamella::trial {
namespace {

// More in tests/session/help.cpp.
TEST(HelpCommand, ShowsThePageAndTheLastError) {
  Trial trial;
  EXPECT_TRUE(contains(trial.out("help help"), "help"));
  EXPECT_EQ(trial.out("help error"), "nothing has gone wrong so far\n");
  const std::string message = trial.failure("refnie");
  EXPECT_EQ(trial.out("help error"), message);
}

}  // namespace
}  // namespace lamella::trial
