#include "support/trial.h"

namespace lamella::trial {
namespace {

TEST(System, RunsALine) {
  Trial trial;
  const Folder folder;
  trial.out("system \"echo made > '" + (folder / "made") + "'\"");
  EXPECT_EQ(file_content(folder / "made"), "made\n");
  EXPECT_TRUE(contains(trial.failure("system \"/no/such/program 2>/dev/null\""), "cannot run"));
}

}  // namespace
}  // namespace lamella::trial
