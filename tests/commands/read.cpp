#include "support/trial.h"

namespace lamella::trial {
namespace {

TEST(Read, RunsTheCommandsInAFile) {
  Trial trial;
  const Folder folder;
  const std::string file =
      folder.write("a.cmd", "x := 3\nif x > 2 then print x\nelse print 0\nfoo := {\n  print x + 1\n}\n");
  EXPECT_EQ(trial.out("read \"" + file + "\"; foo"), "3\n4\n");
  EXPECT_EQ(trial.out("read " + file), "3\n");
  EXPECT_EQ(trial.out("name := \"" + file + "\"; read name"), "3\n");
}

TEST(Read, FailsAsAWholeAndShowsWhere) {
  Trial trial;
  const Folder folder;
  const std::string file = folder.write("bad.cmd", "y := 1\nprint y\nprint nonsense\n");
  const Ran ran = trial.run("read \"" + file + "\"");
  EXPECT_EQ(ran.outcome, session::Outcome::failed);
  EXPECT_TRUE(contains(ran.messages, "bad.cmd:3:7: error"));
  EXPECT_EQ(trial.number("is_defined(\"y\")"), 0);
  EXPECT_TRUE(contains(trial.failure("read nowhere.cmd"), "test:1:6: error: cannot read"));
}

TEST(Read, AFileThatReadsItselfIsAnError) {
  Trial trial;
  const Folder folder;
  const std::string file = folder / "loop.cmd";
  folder.write("loop.cmd", "read \"" + file + "\"\n");
  EXPECT_TRUE(contains(trial.failure("read \"" + file + "\""), "read one another"));
}

}  // namespace
}  // namespace lamella::trial
