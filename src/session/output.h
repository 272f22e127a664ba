// Where commands write: the standard output, a file or another program.
#pragma once

#include <chrono>
#include <cstdio>
#include <string>
#include <string_view>
#include <vector>

#include "language/statement.h"

namespace lamella::session {

// The reader of our standard output has gone (`| head`): there is nothing left to do.
class OutputClosed {};

class Output {
 public:
  // From now on a reader that goes away is an error of writing, not a signal that ends the program.
  Output();
  Output(const Output&) = delete;
  Output& operator=(const Output&) = delete;
  ~Output();

  // Throws OutputClosed. What is written slowly is seen at once, what comes fast is collected.
  void write(std::string_view text);
  void flush();
  bool redirected() const { return !targets_.empty(); }
  // Whether the last character written to the standard output ended its line.
  bool at_line_start() const { return at_line_start_; }
  // Another number whenever the terminal's cursor may have moved: something was written, or typed.
  long position() const { return position_; }
  void note_typing() { ++position_; }

  // Opens a target for what is written until the matching `end`. Throws text::Error where it cannot be
  // opened.
  void begin(language::Redirection kind, const std::string& target);
  // A file that is overwritten gets its content here, whole. Throws text::Error.
  void end();
  // Leaves files that would be overwritten as they were.
  void cancel();

 private:
  struct Target {
    language::Redirection kind = language::Redirection::overwrite;
    std::string name;
    std::string content;           // of a file, until it is written
    std::FILE* program = nullptr;  // of a pipe
  };

  std::vector<Target> targets_;
  bool at_line_start_ = true;
  long position_ = 0;
  std::chrono::steady_clock::time_point flushed_;
};

}  // namespace lamella::session
