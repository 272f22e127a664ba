#include "support/trial.h"

namespace lamella::trial {
namespace {

TEST(Pwd, PrintsTheFolder) {
  Trial trial;
  EXPECT_EQ(trial.out("pwd"), std::filesystem::current_path().string() + "\n");
}

}  // namespace
}  // namespace lamella::trial
