#include "session/program.h"

#include <cerrno>

#include <sys/stat.h>
#include <unistd.h>

#include "session/interrupt.h"
#include "session/machine.h"
#include "session/prompt.h"
#include "session/session.h"
#include "session/terminal.h"
#include "text/whole_file.h"

namespace lamella::session {

namespace {

// The standard input of a program that is not a terminal: a file, or another program that may wait for an
// answer before it goes on. So whatever is there is run as soon as it is complete.
class StandardInput {
 public:
  // Adds what can be read; false at the end.
  bool read_more() {
    char block[1 << 16];
    while (true) {
      const ssize_t count = ::read(STDIN_FILENO, block, sizeof block);
      if (count < 0 && errno == EINTR && !interrupt::requested()) continue;
      if (count <= 0) return false;
      content_.append(block, static_cast<std::size_t>(count));
      return true;
    }
  }

  const std::string& content() const { return content_; }

 private:
  std::string content_;
};

Outcome run_standard_input(Session& session, bool keep_going) {
  struct stat status = {};
  const bool is_file = ::fstat(STDIN_FILENO, &status) == 0 && S_ISREG(status.st_mode);
  StandardInput input;
  std::size_t done = 0;
  Outcome outcome = Outcome::done;
  for (bool more = true; more;) {
    more = input.read_more();
    const std::size_t lines_end = more ? input.content().rfind('\n') : input.content().size();
    if ((is_file && more) || lines_end == std::string::npos || lines_end <= done) continue;
    const text::SourcePointer source = text::make_source("<stdin>", input.content());
    const text::Place part{source, static_cast<std::uint32_t>(done),
                           static_cast<std::uint32_t>(lines_end - done)};
    if (more && !session.is_complete(part)) continue;
    done = lines_end;
    const Outcome ended = session.run(part, keep_going);
    session.output().flush();
    if (ended == Outcome::done) continue;
    outcome = ended;
    if (ended != Outcome::failed || !keep_going) return outcome;
  }
  return outcome;
}

Outcome run_input(Session& session, const Input& input, std::size_t number, bool keep_going) {
  const text::SourcePointer source = input.is_script
                                         ? text::make_source(input.text, text::read_whole_file(input.text))
                                         : text::make_source(fmt::format("-e {}", number), input.text);
  return session.run(source, keep_going);
}

int status_of(Outcome outcome) {
  switch (outcome) {
    case Outcome::failed:
      return command_failed;
    case Outcome::interrupted:
      return stopped;
    default:
      return success;
  }
}

// Scripts that cannot be read are found before anything runs.
bool can_read_scripts(Session& session, const ProgramOptions& options) {
  for (const Input& input : options.inputs) {
    if (!input.is_script) continue;
    try {
      text::read_whole_file(input.text);
    } catch (const text::Error& error) {
      session.report(error);
      return false;
    }
  }
  return true;
}

bool load(Session& session, const std::string& path) {
  try {
    session.load(path);
    return true;
  } catch (const text::Error& error) {
    session.report(error);
  } catch (const Interrupted&) {
    // `quit` at the end of a datafile, or Ctrl-C: what is loaded is there.
    return true;
  }
  return false;
}

int run(Session& session, const ProgramOptions& options) {
  const bool terminal = ::isatty(STDIN_FILENO) != 0;
  if (!can_read_scripts(session, options)) return unusable;
  if (!options.datafile.empty() && !load(session, options.datafile)) return unusable;
  int status = success;
  std::size_t number = 0;
  for (const Input& input : options.inputs) {
    const Outcome outcome = run_input(session, input, ++number, options.keep_going);
    if (outcome == Outcome::done) continue;
    status = status_of(outcome);
    if (outcome != Outcome::failed || !(options.keep_going || options.interactive)) return status;
    if (!options.keep_going) break;
  }
  if (terminal && (options.interactive || options.inputs.empty())) {
    run_prompt(session);
    return status;
  }
  if (options.interactive || options.inputs.empty()) {
    const Outcome outcome = run_standard_input(session, options.keep_going);
    if (outcome != Outcome::done) status = status_of(outcome);
  }
  return status;
}

}  // namespace

std::string_view version() {
  return LAMELLA_VERSION;
}

int run_program(const ProgramOptions& options, std::span<const Command* const> commands) {
  interrupt::watch();
  try {
    Session session(commands);
    session.set_quiet(options.quiet);
    const int status = run(session, options);
    session.output().flush();
    return status;
  } catch (const OutputClosed&) {
    // Whoever read our output has seen enough.
    return success;
  }
}

}  // namespace lamella::session
