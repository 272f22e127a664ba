#include "session/terminal_graphics.h"

#include <algorithm>
#include <cstdlib>

#include <poll.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

#include "session/terminal.h"

namespace lamella::session {

namespace {

// Whether it takes kitty's pictures, the size of a character in pixels, and what kind of terminal it is:
// every terminal answers the last one.
constexpr std::string_view questions = "\x1b_Gi=31,s=1,v=1,a=q,t=d,f=24;AAAA\x1b\\\x1b[16t\x1b[c";

// Keys come as they are typed, unseen, while this lives.
class RawInput {
 public:
  explicit RawInput(int descriptor) : descriptor_(descriptor) {
    if (::tcgetattr(descriptor, &before_) != 0) return;
    termios raw = before_;
    raw.c_lflag &= static_cast<tcflag_t>(~(ICANON | ECHO));
    raw.c_cc[VMIN] = 0;
    raw.c_cc[VTIME] = 0;
    valid_ = ::tcsetattr(descriptor, TCSANOW, &raw) == 0;
  }
  RawInput(const RawInput&) = delete;
  RawInput& operator=(const RawInput&) = delete;
  ~RawInput() {
    if (valid_) ::tcsetattr(descriptor_, TCSANOW, &before_);
  }
  bool valid() const { return valid_; }

 private:
  int descriptor_;
  termios before_ = {};
  bool valid_ = false;
};

// Numbers separated by semicolons.
std::vector<int> numbers_of(std::string_view text) {
  std::vector<int> numbers = {0};
  for (const char c : text) {
    if (c == ';') {
      numbers.push_back(0);
    } else if (c >= '0' && c <= '9') {
      numbers.back() = std::min(numbers.back() * 10 + (c - '0'), 100000);
    }
  }
  return numbers;
}

// `ESC [ ... letter`; returns its length, 0 where it is no such sequence.
std::size_t read_sequence(std::string_view text, Answers& answers) {
  const std::size_t end = text.find_first_not_of("0123456789;?", 2);
  if (end == std::string_view::npos) return 0;
  const std::vector<int> numbers = numbers_of(text.substr(2, end - 2));
  if (text[end] == 'c') {
    answers.complete = true;
    // The first number is the terminal's class.
    answers.sixel = std::find(numbers.begin() + 1, numbers.end(), 4) != numbers.end();
  } else if (text[end] == 't' && numbers.size() == 3 && numbers[0] == 6) {
    answers.cell_height = numbers[1];
    answers.cell_width = numbers[2];
  } else {
    return 0;
  }
  return end + 1;
}

bool environment_says(const char* name, std::initializer_list<std::string_view> parts) {
  const char* const value = std::getenv(name);
  return value != nullptr && std::any_of(parts.begin(), parts.end(), [&](std::string_view part) {
           return std::string_view(value).find(part) != std::string_view::npos;
         });
}

std::string answers_to(int input, int output, std::chrono::milliseconds patience) {
  using Clock = std::chrono::steady_clock;
  std::string got;
  if (::write(output, questions.data(), questions.size()) != static_cast<ssize_t>(questions.size()))
    return got;
  const Clock::time_point end = Clock::now() + patience;
  while (!read_answers(got).complete) {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - Clock::now()).count();
    pollfd waiting = {input, POLLIN, 0};
    if (left <= 0 || ::poll(&waiting, 1, static_cast<int>(left)) <= 0) break;
    char block[256];
    const ssize_t count = ::read(input, block, sizeof block);
    if (count <= 0) break;
    got.append(block, static_cast<std::size_t>(count));
  }
  return got;
}

}  // namespace

Answers read_answers(std::string_view text) {
  Answers answers;
  while (!text.empty()) {
    std::size_t length = 0;
    if (text.starts_with("\x1b_G")) {
      const std::size_t end = text.find("\x1b\\");
      if (end != std::string_view::npos) {
        answers.kitty = text.substr(0, end).find(";OK") != std::string_view::npos;
        length = end + 2;
      }
    } else if (text.starts_with("\x1b[")) {
      length = read_sequence(text, answers);
    }
    if (length == 0) {
      answers.rest += text.front();
      length = 1;
    }
    text.remove_prefix(length);
  }
  return answers;
}

bool draws_pictures(int descriptor) {
  return colours_allowed(descriptor);
}

TerminalLooks ask_terminal(int input, int output, std::chrono::milliseconds patience, std::string& typed) {
  TerminalLooks looks;
  if (environment_says("COLORTERM", {"truecolor", "24bit"}) || environment_says("TERM", {"direct", "kitty"}))
    looks.colours = picture::TerminalColours::all;
  if (::isatty(input) == 0 || ::isatty(output) == 0) return looks;
  const RawInput raw(input);
  if (!raw.valid()) return looks;
  const Answers answers = read_answers(answers_to(input, output, patience));
  typed = answers.rest;
  if (answers.kitty) {
    looks.way = PictureWay::kitty;
  } else if (answers.sixel) {
    looks.way = PictureWay::sixel;
  }
  constexpr int largest_cell = 200;
  if (answers.cell_width > 0 && answers.cell_width < largest_cell && answers.cell_height > 0 &&
      answers.cell_height < largest_cell) {
    looks.cell_width = answers.cell_width;
    looks.cell_height = answers.cell_height;
  }
  return looks;
}

WindowSize window_size(int descriptor) {
  winsize size = {};
  if (::ioctl(descriptor, TIOCGWINSZ, &size) != 0 || size.ws_col == 0 || size.ws_row == 0) return {};
  return {size.ws_col, size.ws_row};
}

}  // namespace lamella::session
