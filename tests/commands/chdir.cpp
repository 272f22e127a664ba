#include "support/trial.h"

namespace lamella::trial {
namespace {

TEST(Chdir, GoesThere) {
  Trial trial;
  const Folder folder;
  const std::string before = trial.out("pwd");
  trial.out("chdir \"" + (folder / "") + "\"");
  EXPECT_NE(trial.out("pwd"), before);
  trial.out("chdir \"" + before.substr(0, before.size() - 1) + "\"");
  EXPECT_EQ(trial.out("pwd"), before);
  EXPECT_TRUE(
      contains(trial.failure("chdir \"/nowhere at all\""), "cannot go to \"/nowhere at all\": No such file"));
}

}  // namespace
}  // namespace lamella::trial
