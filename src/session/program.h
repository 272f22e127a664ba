// The program from its command line to its exit status.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "session/command.h"

namespace lamella::session {

// Commands given on the command line: the text itself (-e) or a script (-f).
struct Input {
  bool is_script = false;
  std::string text;
};

struct ProgramOptions {
  std::string datafile;  // empty for none
  std::vector<Input> inputs;
  bool interactive = false;  // goes on at the prompt when the inputs are done
  bool quiet = false;
  bool keep_going = false;
};

std::string_view version();

enum ExitStatus : int { success = 0, command_failed = 1, unusable = 2, stopped = 130 };

// Loads the datafile, runs the inputs, then what comes on the standard input, where that is called for.
int run_program(const ProgramOptions& options, std::span<const Command* const> commands);

}  // namespace lamella::session
