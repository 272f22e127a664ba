#include "session/session.h"

#include <cmath>
#include <map>
#include <new>

#include "datafile/read.h"
#include "session/history.h"
#include "session/interrupt.h"
#include "session/machine.h"
#include "session/progress.h"
#include "session/show_filter.h"
#include "session/switches.h"
#include "session/terminal.h"
#include "text/whole_file.h"

namespace lamella::session {

using language::Lexer;
using language::LexerMode;
using language::LexerStream;
using language::StatementParser;

namespace {

constexpr int deepest_reads = 50;
constexpr double first_seed = 1;

// A statement in one line, cut if it is long.
std::string label_of(const std::string& text) {
  constexpr std::size_t longest = 60;
  std::string label;
  for (const char c : text) {
    const bool space = c == ' ' || c == '\t' || c == '\n' || c == '\r';
    if (!space) label += c;
    if (space && !label.ends_with(' ')) label += ' ';
    if (label.size() == longest) return label + "...";
  }
  return label;
}

text::Place whole(const text::SourcePointer& source) {
  return {source, 0, static_cast<std::uint32_t>(source->content.size())};
}

}  // namespace

struct Session::State {
  State(Session& session, std::span<const Command* const> commands)
      : names(scene, attributes, commands),
        machine(session),
        progress([&session](std::string_view line) { session.tell("{}\n", line); }) {}

  scene::Scene scene;
  energy::MeasureCache measures;
  Attributes attributes;
  Names names;
  Machine machine;
  Output output;
  Progress progress;
  Follower follower;
  History history;
  std::map<std::string, double, std::less<>> counters;
  std::map<std::type_index, std::any> memories;
  std::mt19937_64 random{static_cast<std::uint64_t>(first_seed)};
  double seed = first_seed;
  std::string last_error;
  bool quiet = false;
  bool quit = false;
  bool loading = false;
  long undo_request = 0;
  int reads = 0;
  bool file_missing = false;  // the last statement failed because a file could not be read
};

Session::Session(std::span<const Command* const> commands)
    : state_(std::make_unique<State>(*this, commands)) {}
Session::~Session() = default;

// --- what commands see

scene::Scene& Session::scene() {
  return state_->scene;
}
const scene::Scene& Session::scene() const {
  return state_->scene;
}
const energy::Measures& Session::measures() {
  return state_->measures.of(state_->scene);
}
void Session::write(std::string_view text) {
  if (!state_->output.redirected()) state_->progress.erase();
  state_->output.write(text);
}
bool Session::quiet() const {
  return state_->quiet;
}
void Session::set_quiet(bool quiet) {
  state_->quiet = quiet;
}
bool Session::is_loading() const {
  return state_->loading;
}
Output& Session::output() {
  return state_->output;
}
scene::Monitor& Session::monitor() {
  return state_->progress;
}
Session::Follower Session::follow_steps(Follower follower) {
  std::swap(state_->follower, follower);
  state_->progress.follow(state_->follower ? [this] { state_->follower(state_->scene, false); }
                                           : std::function<void()>{});
  return follower;
}
std::any& Session::memory_of(std::type_index type) {
  return state_->memories[type];
}
std::mt19937_64& Session::random() {
  return state_->random;
}
double Session::random_seed() const {
  return state_->seed;
}
void Session::seed_random(double seed) {
  state_->seed = seed;
  state_->random.seed(static_cast<std::uint64_t>(std::llround(seed)));
}
language::Evaluation& Session::evaluation() {
  return state_->machine.evaluation();
}
Names& Session::names() {
  return state_->names;
}
Attributes& Session::attributes() {
  return state_->attributes;
}
AttributeSource Session::attribute_source() {
  return {state_->scene, state_->measures};
}

double& Session::counter(std::string_view name) {
  const auto at = state_->counters.find(name);
  return at != state_->counters.end() ? at->second : state_->counters[std::string(name)];
}

void Session::begin_command() {
  state_->progress.restart();
}

void Session::warn(const text::Diagnostic& warning) {
  state_->progress.erase();
  state_->output.flush();
  write_error(text::render(warning));
}

void Session::warn(std::string message) {
  warn(text::Diagnostic{text::Severity::warning, {}, std::move(message), {}, {}});
}

void Session::report(const text::Error& error) {
  state_->progress.restart();
  state_->output.flush();
  state_->last_error = error.what();
  write_error(state_->last_error);
}

const std::string& Session::last_error() const {
  return state_->last_error;
}

void Session::request_undo(long steps) {
  const long wanted = state_->undo_request + steps;
  const auto past = static_cast<long>(state_->history.undo_steps());
  const auto future = static_cast<long>(state_->history.redo_steps());
  if (wanted > past)
    throw text::Error(past == 0 ? "there is nothing to undo"
                                : fmt::format("there are only {} steps to undo", past));
  if (-wanted > future)
    throw text::Error(future == 0 ? "there is nothing to redo"
                                  : fmt::format("there are only {} steps to redo", future));
  state_->undo_request = wanted;
}

void Session::request_quit() {
  state_->quit = true;
  throw Interrupted{};
}

// --- running text

namespace {

// Statements that are parsed before the first of them runs: those of a line, up to one that may bring names.
struct Batch {
  struct Statement {
    std::shared_ptr<const language::Block> block;
    std::string text;
  };
  std::vector<Statement> statements;
  bool at_end = false;
};

Batch parse_batch(StatementParser& parser, Names& names) {
  Batch batch;
  do {
    auto [block, text] = parser.next_with_text();
    batch.at_end = block == nullptr;
    if (batch.at_end) return batch;
    batch.statements.push_back({std::move(block), std::move(text)});
  } while (!names.take_brings_names() && !parser.at_line_end());
  return batch;
}

}  // namespace

Outcome Session::run(const text::SourcePointer& source, bool keep_going) {
  return run(whole(source), keep_going);
}

Outcome Session::run(const text::Place& part, bool keep_going) {
  Outcome outcome = Outcome::done;
  std::optional<LexerStream> tokens;
  try {
    tokens.emplace(Lexer(part, LexerMode::command));
  } catch (const text::Error& error) {
    report(error);
    return Outcome::failed;
  }
  StatementParser parser(*tokens, state_->names);
  while (true) {
    const std::uint32_t begin = tokens->previous_end();
    Batch batch;
    try {
      batch = parse_batch(parser, state_->names);
    } catch (const text::Error& error) {
      report(error);
      outcome = Outcome::failed;
      if (!keep_going) break;
      tokens->rewind(begin);
      parser.skip_statement_line();
      continue;
    }
    for (const auto& [block, text] : batch.statements) {
      const Outcome ended = run_statement(*block, text);
      if (ended == Outcome::done) continue;
      outcome = ended;
      if (ended != Outcome::failed || !keep_going) break;
    }
    const bool ends = outcome == Outcome::quit || outcome == Outcome::interrupted ||
                      (outcome == Outcome::failed && !keep_going);
    if (batch.at_end || ends) break;
  }
  state_->names.forget_promises();
  return outcome;
}

Outcome Session::run_statement(const language::Block& statement, const std::string& text) {
  scene::Scene before = state_->scene;
  state_->undo_request = 0;
  const auto fail = [&](const text::Error& error) {
    state_->scene = std::move(before);
    report(error);
    return Outcome::failed;
  };
  try {
    language::execute(statement, state_->machine, state_->machine.evaluation());
  } catch (const Interrupted&) {
  } catch (const text::Error& error) {
    return fail(error);
  } catch (const std::bad_alloc&) {
    return fail(text::Error("out of memory"));
  } catch (const std::exception& error) {
    return fail(text::Error(fmt::format("internal fault: {}", error.what())));
  }
  state_->progress.restart();
  const bool changed = differs(before, state_->scene) || state_->undo_request != 0;
  if (differs(before, state_->scene)) state_->history.push(std::move(before), label_of(text));
  apply_requested_undo();
  if (changed && state_->follower && !state_->quit) state_->follower(state_->scene, true);
  if (state_->quit) return Outcome::quit;
  if (!interrupt::requested()) return Outcome::done;
  state_->output.flush();
  write_error("stopped by Ctrl-C; the scene is kept as it is now\n");
  return Outcome::interrupted;
}

void Session::apply_requested_undo() {
  const long steps = std::exchange(state_->undo_request, 0);
  for (long i = 0; i < steps; ++i) {
    if (const auto undone = state_->history.undo(state_->scene)) tell("undo: {}\n", *undone);
  }
  for (long i = 0; i > steps; --i) {
    if (const auto redone = state_->history.redo(state_->scene)) tell("redo: {}\n", *redone);
  }
}

void Session::run_within(const text::Place& part) {
  if (state_->reads >= deepest_reads) {
    throw text::Error(fmt::format("more than {} files read one another", deepest_reads),
                      "a file that reads itself never ends");
  }
  ++state_->reads;
  LexerStream tokens(Lexer(part, LexerMode::command));
  StatementParser parser(tokens, state_->names);
  try {
    for (bool more = true; more;) {
      const Batch batch = parse_batch(parser, state_->names);
      for (const Batch::Statement& statement : batch.statements) {
        language::execute(*statement.block, state_->machine, state_->machine.evaluation());
      }
      more = !batch.at_end;
    }
  } catch (...) {
    --state_->reads;
    throw;
  }
  --state_->reads;
}

namespace {

// As a warning, of which a datafile's commands give many.
text::Diagnostic left_out(const text::Error& error) {
  text::Diagnostic diagnostic = error.diagnostics().front();
  diagnostic.severity = text::Severity::warning;
  diagnostic.message += "; this command is left out";
  return diagnostic;
}

}  // namespace

bool Session::run_or_restore(const language::Block& statement, std::optional<text::Error>& failure) {
  scene::Scene before = state_->scene;
  state_->file_missing = false;
  try {
    language::execute(statement, state_->machine, state_->machine.evaluation());
    return true;
  } catch (const text::Error& error) {
    state_->scene = std::move(before);
    failure = error;
    return false;
  }
}

long Session::run_what_can_be(const text::Place& part) {
  constexpr int most_told = 8;
  long failures = 0;
  const auto leave_out = [&](const text::Error& error) {
    if (++failures <= most_told) warn(left_out(error));
  };
  LexerStream tokens(Lexer(part, LexerMode::command));
  StatementParser parser(tokens, state_->names);
  for (bool more = true; more;) {
    const std::uint32_t begin = tokens.previous_end();
    Batch batch;
    try {
      batch = parse_batch(parser, state_->names);
    } catch (const text::Error& error) {
      leave_out(error);
      tokens.rewind(begin);
      parser.skip_statement_line();
      continue;
    }
    more = !batch.at_end;
    std::optional<text::Error> failure;
    for (const Batch::Statement& statement : batch.statements) {
      if (run_or_restore(*statement.block, failure)) continue;
      leave_out(*failure);
      if (!state_->file_missing) continue;
      warn("the rest of the datafile's commands is left out too: they may need what that file defines");
      more = false;
      break;
    }
  }
  state_->names.forget_promises();
  if (failures > most_told) warn(fmt::format("{} more commands are left out", failures - most_told));
  return failures;
}

void Session::run_within(const language::Block& commands) {
  language::execute(commands, state_->machine, state_->machine.evaluation());
}

void Session::read(const std::string& path) {
  state_->file_missing = true;
  const text::SourcePointer source = text::make_source(path, text::read_whole_file(path));
  state_->file_missing = false;
  run_within(whole(source));
}

void Session::load(const std::string& path) {
  datafile::ReadResult result = datafile::read_datafile(path, &state_->scene.variables);
  for (const text::Diagnostic& warning : result.warnings) warn(warning);
  state_->scene = std::move(result.scene);
  state_->counters.clear();
  show_only(*this, {});
  reset_switches(*this);
  seed_random(first_seed);
  const bool outer = std::exchange(state_->loading, true);
  long left_out = 0;
  try {
    for (const text::Place& declaration : result.procedures) left_out += run_what_can_be(declaration);
    for (const text::Place& commands : result.read_section) left_out += run_what_can_be(commands);
  } catch (...) {
    state_->loading = outer;
    throw;
  }
  state_->loading = outer;
  const film::Film& film = state_->scene.film;
  tell("{}: {} vertices, {} edges, {} facets, {} bodies\n", path, film.vertex_count(), film.edge_count(),
       scene::facet_count(state_->scene), scene::body_count(state_->scene));
  if (left_out > 0)
    tell("{} of the commands at its end {} left out\n", left_out, left_out == 1 ? "was" : "were");
}

bool Session::is_complete(const text::Place& part) {
  bool complete = true;
  try {
    LexerStream tokens(Lexer(part, LexerMode::command));
    StatementParser parser(tokens, state_->names);
    while (parser.next() != nullptr) {
    }
  } catch (const language::Incomplete&) {
    complete = false;
  } catch (const text::Error&) {
    // Wrong, but nothing that more text would mend.
  }
  state_->names.forget_promises();
  return complete;
}

}  // namespace lamella::session
