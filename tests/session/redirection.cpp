#include "support/trial.h"

namespace lamella::trial {
namespace {

TEST(Redirection, OverwritesAppendsAndPipes) {
  Trial trial;
  const Folder folder;
  const std::string file = folder / "out.txt";
  EXPECT_EQ(trial.out("print 1 > \"" + file + "\""), "");
  EXPECT_EQ(file_content(file), "1\n");
  trial.out("print 2 >> \"" + file + "\"");
  EXPECT_EQ(file_content(file), "1\n2\n");
  trial.out("print 3 >>> \"" + file + "\"");
  EXPECT_EQ(file_content(file), "3\n");
  trial.out("{ print 1; print 2 } | \"sort -r > " + file + "\"");
  EXPECT_EQ(file_content(file), "2\n1\n");
  trial.out("name := \"" + file + "\"; print 4 >> name");
  EXPECT_EQ(file_content(file), "2\n1\n4\n");
}

TEST(Redirection, TakesAWholeLoopOrBranch) {
  Trial trial;
  const Folder folder;
  const std::string file = folder / "out.txt";
  trial.out("for (i := 0; i < 3; i++) print i > \"" + file + "\"");
  EXPECT_EQ(file_content(file), "0\n1\n2\n");
  EXPECT_EQ(trial.out("if 0 then print 1 > \"" + file + "\" else print 2"), "2\n");
  EXPECT_EQ(trial.out("print 3 > 2"), "1\n");
}

TEST(Redirection, AFailureLeavesTheFileAlone) {
  Trial trial;
  const Folder folder;
  const std::string file = folder.write("out.txt", "old\n");
  trial.failure("{ print 1; print 1/0 } > \"" + file + "\"");
  EXPECT_EQ(file_content(file), "old\n");
  EXPECT_TRUE(contains(trial.failure("print 1 > \"" + (folder / "none/out.txt") + "\""), "cannot write"));
  EXPECT_FALSE(std::filesystem::exists(folder / "none"));
}

TEST(Redirection, AReaderThatStopsEarlyIsNoError) {
  Trial trial;
  const Folder folder;
  trial.out("for (i := 0; i < 100000; i++) print i | \"head -1 > " + (folder / "head.txt") + "\"");
  EXPECT_EQ(file_content(folder / "head.txt"), "0\n");
}

}  // namespace
}  // namespace lamella::trial
