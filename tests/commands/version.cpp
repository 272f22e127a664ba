#include "support/trial.h"

namespace lamella::trial {
namespace {

TEST(Version, Tells) {
  Trial trial;
  EXPECT_TRUE(trial.out("version").starts_with("lamella "));
  EXPECT_EQ("lamella " + trial.out("print evolver_version"), trial.out("version"));
}

}  // namespace
}  // namespace lamella::trial
