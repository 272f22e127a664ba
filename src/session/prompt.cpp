#include "session/prompt.h"

// readline's header needs FILE to be known.
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <optional>
#include <string>

#include <poll.h>
#include <readline/history.h>
#include <readline/readline.h>
#include <unistd.h>

#include "session/completion.h"
#include "session/interrupt.h"
#include "session/program.h"
#include "session/session.h"

namespace lamella::session {

namespace {

namespace fs = std::filesystem;

constexpr int history_lines = 2000;
constexpr const char* first_prompt = "lamella> ";
constexpr const char* more_prompt = "   more> ";

// readline's hooks are plain functions: this is who they serve while a prompt is open.
Session* served = nullptr;

// $XDG_STATE_HOME/lamella/history or ~/.local/state/lamella/history; nothing where neither can be had.
std::optional<fs::path> history_path() {
  const char* const state = std::getenv("XDG_STATE_HOME");
  const char* const home = std::getenv("HOME");
  fs::path folder;
  if (state != nullptr && *state != '\0') {
    folder = state;
  } else if (home != nullptr && *home != '\0') {
    folder = fs::path(home) / ".local" / "state";
  } else {
    return std::nullopt;
  }
  std::error_code ignored;
  fs::create_directories(folder / "lamella", ignored);
  return folder / "lamella" / "history";
}

// The history of the runs before, and of this one for the next. Where it cannot be kept it is not.
class HistoryFile {
 public:
  HistoryFile() : path_(history_path()) {
    ::using_history();
    ::stifle_history(history_lines);
    if (path_) ::read_history(path_->c_str());
  }
  HistoryFile(const HistoryFile&) = delete;
  HistoryFile& operator=(const HistoryFile&) = delete;

  void add(const std::string& text) {
    const HIST_ENTRY* const last =
        ::history_length > 0 ? ::history_get(::history_base + ::history_length - 1) : nullptr;
    if (text.empty() || (last != nullptr && text == last->line)) return;
    ::add_history(text.c_str());
    if (!path_) return;
    if (::append_history(1, path_->c_str()) != 0) ::write_history(path_->c_str());
  }

 private:
  std::optional<fs::path> path_;
};

char** offer(const char*, int begin, int end) {
  const std::string line(::rl_line_buffer, static_cast<std::size_t>(end));
  const Completion completion = complete(*served, line);
  ::rl_attempted_completion_over = completion.files ? 0 : 1;
  ::rl_filename_completion_desired = 0;
  ::rl_completion_append_character = ' ';
  if (completion.candidates.empty() || completion.begin != static_cast<std::size_t>(begin)) return nullptr;
  // readline wants what all candidates share, the candidates, and a null.
  const std::vector<std::string>& all = completion.candidates;
  std::size_t shared = all.front().size();
  for (const std::string& candidate : all) {
    std::size_t i = 0;
    while (i < std::min(shared, candidate.size()) && candidate[i] == all.front()[i]) ++i;
    shared = i;
  }
  const std::size_t count = all.size() == 1 ? 0 : all.size();
  char** const matches = static_cast<char**>(std::calloc(count + 2, sizeof(char*)));
  matches[0] = ::strdup(all.front().substr(0, shared).c_str());
  for (std::size_t i = 0; i < count; ++i) matches[i + 1] = ::strdup(all[i].c_str());
  return matches;
}

void set_up_readline() {
  ::rl_readline_name = "lamella";
  ::rl_catch_signals = 0;
  ::rl_attempted_completion_function = offer;
  ::rl_completer_word_break_characters = " \t\n\"\\'`@$><=;|&{(,)}[].+-*/%^!?:";
  ::rl_variable_bind("enable-bracketed-paste", "on");
}

// A file's name has dots and dashes in it, so what breaks words depends on where the cursor is.
char* word_breaks() {
  static char in_files[] = " \t\n\"'`><=;|&{(,)}";
  static char elsewhere[] = " \t\n\"\\'`@$><=;|&{(,)}[].+-*/%^!?:";
  const std::string line(::rl_line_buffer, static_cast<std::size_t>(::rl_point));
  return complete(*served, line).files ? in_files : elsewhere;
}

// --- one line

struct Typed {
  std::string text;
  bool dropped = false;  // by Ctrl-C
  bool ended = false;    // no more lines
};

// Where readline puts the line that is being typed.
std::optional<Typed> finished;

void finish_line(char* line) {
  finished = line != nullptr ? Typed{line, false, false} : Typed{"", false, true};
  std::free(line);
  ::rl_callback_handler_remove();
}

// Ctrl-C while a line is typed: the line goes.
Typed drop_line() {
  interrupt::clear();
  std::fputs("^C", stdout);
  std::fflush(stdout);
  ::rl_free_line_state();
  ::rl_callback_sigcleanup();
  ::rl_callback_handler_remove();
  std::fputs("\n", stdout);
  return {"", true, false};
}

Typed read_line(const char* prompt) {
  finished.reset();
  ::rl_callback_handler_install(prompt, finish_line);
  while (!finished) {
    pollfd input = {STDIN_FILENO, POLLIN, 0};
    const int ready = ::poll(&input, 1, -1);
    if (interrupt::requested()) return drop_line();
    if (ready > 0) ::rl_callback_read_char();
  }
  return *finished;
}

// Lines until the commands on them are complete.
std::optional<std::string> read_statement(Session& session) {
  std::string text;
  for (bool first = true;; first = false) {
    const Typed typed = read_line(first ? first_prompt : more_prompt);
    if (typed.ended) return std::nullopt;
    if (typed.dropped) return std::string{};
    text += (first ? "" : "\n") + typed.text;
    const text::SourcePointer source = text::make_source("<prompt>", text);
    if (session.is_complete({source, 0, static_cast<std::uint32_t>(text.size())})) return text;
  }
}

// `?` repeats the last error, `? word` is short for help.
std::string without_question_mark(const std::string& text) {
  const std::size_t begin = text.find_first_not_of(" \t");
  if (begin == std::string::npos || text[begin] != '?') return text;
  const std::string rest = text.substr(begin + 1);
  return rest.find_first_not_of(" \t") == std::string::npos ? "help error" : "help " + rest;
}

}  // namespace

void run_prompt(Session& session) {
  served = &session;
  interrupt::clear();
  set_up_readline();
  ::rl_completion_word_break_hook = word_breaks;
  HistoryFile history;
  session.tell("Lamella {}: help lists the commands, Ctrl-C stops one, Ctrl-D ends the session\n", version());
  while (true) {
    session.output().flush();
    if (!session.output().at_line_start()) session.write("\n");
    const std::optional<std::string> text = read_statement(session);
    if (!text) {
      session.write("\n");
      break;
    }
    session.output().note_typing();
    history.add(*text);
    const Outcome outcome = session.run(text::make_source("<prompt>", without_question_mark(*text)));
    interrupt::clear();
    if (outcome == Outcome::quit) break;
  }
  served = nullptr;
}

}  // namespace lamella::session
