// The program run as people run it.
#include <array>
#include <cstdio>

#include <sys/wait.h>

#include "support/trial.h"

namespace lamella::trial {
namespace {

struct Result {
  std::string out;
  std::string messages;
  int status = -1;
};

class Program : public ::testing::Test {
 protected:
  // Runs the program in a shell, in the test's folder, with this standard input.
  Result run(const std::string& arguments, const std::string& input = {}) const {
    folder_.write("in.txt", input);
    return shell("'" LAMELLA_BINARY "' " + arguments + " < in.txt > out.txt 2> err.txt");
  }
  Result shell(const std::string& command) const {
    const int status = std::system(("cd '" + (folder_ / ".") + "' && " + command).c_str());
    return {file_content(folder_ / "out.txt"), file_content(folder_ / "err.txt"), WEXITSTATUS(status)};
  }
  const Folder folder_;
  const std::string cube_ = fmt::format("'{}'", datafile("cube.fe"));
};

TEST_F(Program, PrintsWhatIsAskedAndNothingElse) {
  const Result ran = run("-q " + cube_ + " -e 'print total_area'");
  EXPECT_EQ(ran.out, "6\n");
  EXPECT_EQ(ran.messages, "");
  EXPECT_EQ(ran.status, 0);
  EXPECT_EQ(run("-q " + cube_ + " -e 'refine; x := 3; set vertex fixed where id < 3; save \"a.fe\"'").out,
            "");
}

TEST_F(Program, RunsCommandsAndScriptsInTheirOrder) {
  folder_.write("two.cmd", "print 2\n");
  EXPECT_EQ(run("-e 'print 1' -f two.cmd -e 'print 3'").out, "1\n2\n3\n");
}

TEST_F(Program, StatusTellsHowItEnded) {
  EXPECT_EQ(run("-e 'print 1'").status, 0);
  EXPECT_EQ(run("-e 'print 1/0; print 2'").status, 1);
  EXPECT_EQ(run("-e 'print 1/0; print 2'").out, "");
  const Result going = run("--keep-going -e 'print 1/0; print 2' -e 'print 3'");
  EXPECT_EQ(going.out, "2\n3\n");
  EXPECT_EQ(going.status, 1);
  EXPECT_EQ(run("nofile.fe -e 'print 1'").status, 2);
  EXPECT_EQ(run("-f nofile.cmd").status, 2);
  EXPECT_EQ(run("--nonsense").status, 2);
  EXPECT_EQ(run("-e").status, 2);
  EXPECT_EQ(run("-e 'print 1; quit; print 2' -e 'print 3'").out, "1\n");
  EXPECT_EQ(run("-e 'quit'").status, 0);
  folder_.write("bad.fe", "vertices\n1 0 0\n");
  const Result bad = run("bad.fe -e 'print 1'");
  EXPECT_EQ(bad.status, 2);
  EXPECT_EQ(bad.out, "");
  EXPECT_TRUE(contains(bad.messages, "bad.fe:2:"));
}

TEST_F(Program, ReadsTheStandardInput) {
  EXPECT_EQ(run("-q", "print 1\nif 0 then print 2\nelse print 3\n").out, "1\n3\n");
  EXPECT_EQ(run("-q -e 'print 1'", "print 2\n").out, "1\n");
  EXPECT_EQ(run("-q -i -e 'print 1'", "print 2\n").out, "1\n2\n");
  const Result failed = run("-q", "print 1\nprint foo\nprint 2\n");
  EXPECT_EQ(failed.out, "1\n");
  EXPECT_EQ(failed.status, 1);
  EXPECT_TRUE(contains(failed.messages, "<stdin>:2:7"));
  EXPECT_EQ(run("-q", "print 1 +").status, 1);
}

// A program at the other end of a pipe may wait for each answer.
TEST_F(Program, AnswersLineByLine) {
  folder_.write("talk.sh", "mkfifo to from\n'" LAMELLA_BINARY
                           "' -q < to > from &\nexec 3> to 4< from\n"
                           "echo 'print 6*7' >&3\nread answer <&4\necho \"got $answer\"\n"
                           "echo 'for (i := 0; i < 2; i++) {' >&3\necho 'print i }' >&3\n"
                           "read a <&4\nread b <&4\necho \"got $a $b\"\nexec 3>&-\nwait\n");
  EXPECT_EQ(shell("timeout 60 sh talk.sh > out.txt 2> err.txt").status, 0);
  EXPECT_EQ(file_content(folder_ / "out.txt"), "got 42\ngot 0 1\n");
}

TEST_F(Program, AClosedPipeEndsItQuietly) {
  shell("('" LAMELLA_BINARY
        "' -q -e 'for (i := 0; i < 1000000; i++) print i' 2> err.txt; echo $? > status.txt)"
        " | head -1 > out.txt");
  EXPECT_EQ(file_content(folder_ / "out.txt"), "0\n");
  EXPECT_EQ(file_content(folder_ / "err.txt"), "");
  EXPECT_EQ(file_content(folder_ / "status.txt"), "0\n");
}

TEST_F(Program, OutputAndMessagesComeInOrder) {
  const std::string both =
      shell("'" LAMELLA_BINARY "' --keep-going -e 'print 1; print 1/0; print 2' > out.txt 2>&1").out;
  EXPECT_LT(both.find("1\n"), both.find("division"));
  EXPECT_LT(both.find("division"), both.rfind("2\n"));
}

TEST_F(Program, TellsItsVersionAndUsage) {
  EXPECT_TRUE(contains(run("--version").out, "lamella "));
  EXPECT_TRUE(contains(run("--help").out, "--keep-going"));
  EXPECT_EQ(run("--help").status, 0);
}

TEST_F(Program, NoColoursInFiles) {
  EXPECT_EQ(run("-e foo").messages.find('\x1b'), std::string::npos);
}

}  // namespace
}  // namespace lamella::trial
