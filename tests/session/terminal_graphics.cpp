// What the session makes of a terminal's answers, and of one that never answers.
#include "session/terminal_graphics.h"

#include <thread>

#include <fcntl.h>
#include <poll.h>
#include <termios.h>
#include <unistd.h>

#include "support/trial.h"

namespace lamella::session {
namespace {

TEST(TerminalGraphics, AnswersAreRead) {
  const Answers kitty = read_answers("\x1b_Gi=31;OK\x1b\\\x1b[6;20;10t\x1b[?62;c");
  EXPECT_TRUE(kitty.kitty);
  EXPECT_FALSE(kitty.sixel);
  EXPECT_TRUE(kitty.complete);
  EXPECT_EQ(kitty.cell_height, 20);
  EXPECT_EQ(kitty.cell_width, 10);
  const Answers sixel = read_answers("\x1b[?62;4;22c");
  EXPECT_TRUE(sixel.sixel);
  EXPECT_FALSE(sixel.kitty);
  EXPECT_FALSE(read_answers("\x1b[?4;22c").sixel);  // the first number is no feature
  EXPECT_FALSE(read_answers("\x1b_Gi=31;ENOTSUPPORTED\x1b\\\x1b[?1c").kitty);
  EXPECT_FALSE(read_answers("\x1b[?62;4").complete);
}

TEST(TerminalGraphics, WhatIsTypedMeanwhileIsKept) {
  const Answers answers = read_answers("re\x1b[?1;2clax");
  EXPECT_TRUE(answers.complete);
  EXPECT_EQ(answers.rest, "relax");
}

// A terminal of which a test holds the other end.
class PseudoTerminal {
 public:
  PseudoTerminal() : master_(::posix_openpt(O_RDWR | O_NOCTTY)) {
    if (master_ < 0 || ::grantpt(master_) != 0 || ::unlockpt(master_) != 0) return;
    slave_ = ::open(::ptsname(master_), O_RDWR | O_NOCTTY);
  }
  PseudoTerminal(const PseudoTerminal&) = delete;
  PseudoTerminal& operator=(const PseudoTerminal&) = delete;
  ~PseudoTerminal() {
    ::close(slave_);
    ::close(master_);
  }
  int slave() const { return slave_; }
  bool works() const { return slave_ >= 0; }

  // Waits until the last question has come, and answers.
  void answer(const std::string& text) const {
    std::string asked;
    while (asked.find("\x1b[c") == std::string::npos) {
      char block[256];
      const ssize_t count = ::read(master_, block, sizeof block);
      if (count <= 0) return;
      asked.append(block, static_cast<std::size_t>(count));
    }
    EXPECT_EQ(::write(master_, text.data(), text.size()), static_cast<ssize_t>(text.size()));
  }

 private:
  int master_ = -1;
  int slave_ = -1;
};

TEST(TerminalGraphics, ATerminalIsAsked) {
  const PseudoTerminal terminal;
  if (!terminal.works()) GTEST_SKIP() << "there are no pseudo-terminals here";
  std::thread other([&] { terminal.answer("\x1b[6;18;9t\x1b[?62;4c"); });
  std::string typed;
  const TerminalLooks looks =
      ask_terminal(terminal.slave(), terminal.slave(), std::chrono::seconds(20), typed);
  other.join();
  EXPECT_EQ(looks.way, PictureWay::sixel);
  EXPECT_EQ(looks.cell_width, 9);
  EXPECT_EQ(looks.cell_height, 18);
  EXPECT_EQ(typed, "");
}

TEST(TerminalGraphics, OneThatDoesNotAnswerGetsHalfBlocks) {
  const PseudoTerminal terminal;
  if (!terminal.works()) GTEST_SKIP() << "there are no pseudo-terminals here";
  termios before = {};
  termios after = {};
  ASSERT_EQ(::tcgetattr(terminal.slave(), &before), 0);
  std::string typed;
  const TerminalLooks looks =
      ask_terminal(terminal.slave(), terminal.slave(), std::chrono::milliseconds(10), typed);
  EXPECT_EQ(looks.way, PictureWay::half_blocks);
  ASSERT_EQ(::tcgetattr(terminal.slave(), &after), 0);
  EXPECT_EQ(after.c_lflag, before.c_lflag);
}

TEST(TerminalGraphics, APipeIsNotAsked) {
  int ends[2];
  ASSERT_EQ(::pipe(ends), 0);
  std::string typed;
  EXPECT_EQ(ask_terminal(ends[0], ends[1], std::chrono::seconds(20), typed).way, PictureWay::half_blocks);
  pollfd waiting = {ends[0], POLLIN, 0};
  EXPECT_EQ(::poll(&waiting, 1, 0), 0);  // nothing was written
  EXPECT_FALSE(draws_pictures(ends[1]));
  ::close(ends[0]);
  ::close(ends[1]);
}

}  // namespace
}  // namespace lamella::session
