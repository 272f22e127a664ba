// A session: the scene, and everything that lives as long as the program does.
//
// Commands see of it: the scene (which they may change as they like), where to write, the monitor of long
// computations, counters, random numbers, and the values of expressions they were given unevaluated.
#pragma once

#include <any>
#include <functional>
#include <memory>
#include <random>
#include <string>
#include <string_view>
#include <typeindex>

#include <fmt/format.h>

#include "energy/measure.h"
#include "language/evaluate.h"
#include "scene/monitor.h"
#include "scene/scene.h"
#include "session/command.h"
#include "session/names.h"
#include "session/output.h"
#include "text/error.h"

namespace lamella::session {

// How a text ended that was run.
enum class Outcome : std::uint8_t { done, failed, interrupted, quit };

class Session {
 public:
  explicit Session(std::span<const Command* const> commands);
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  // --- the scene. To change it in a command needs no ceremony: a failure takes everything back.
  scene::Scene& scene();
  const scene::Scene& scene() const;
  const energy::Measures& measures();

  // --- output, to wherever it is redirected
  void write(std::string_view text);
  // What was asked for.
  template <class... Values>
  void print(fmt::format_string<Values...> format, Values&&... values) {
    write(fmt::format(format, std::forward<Values>(values)...));
  }
  // What a command tells of its own accord; silent under -q.
  template <class... Values>
  void tell(fmt::format_string<Values...> format, Values&&... values) {
    if (!quiet()) write(fmt::format(format, std::forward<Values>(values)...));
  }
  bool quiet() const;
  void set_quiet(bool quiet);
  Output& output();
  // To the standard error output, never redirected.
  void warn(const text::Diagnostic& warning);
  void warn(std::string message);
  void report(const text::Error& error);
  // As `report` showed it; empty if there was none.
  const std::string& last_error() const;

  // --- long computations: asks to stop on Ctrl-C, draws the progress line
  scene::Monitor& monitor();
  // From now on called after each step of a long computation, with the scene as it is then, and once more
  // when a statement has changed the scene and is done (`settled`); an empty function ends that. Returns what
  // was called before.
  using Follower = std::function<void(const scene::Scene& scene, bool settled)>;
  Follower follow_steps(Follower follower);

  // --- small things
  // Counters such as `refine_count`, readable as variables after a command has set them.
  double& counter(std::string_view name);
  std::mt19937_64& random();
  double random_seed() const;
  void seed_random(double seed);

  // What a command remembers from one of its runs to the next: one value of each type, blank at first.
  template <class Memory>
  Memory& memory() {
    std::any& kept = memory_of(typeid(Memory));
    if (!kept.has_value()) kept = Memory{};
    return *std::any_cast<Memory>(&kept);
  }

  // --- names and values
  language::Evaluation& evaluation();
  Names& names();
  Attributes& attributes();
  AttributeSource attribute_source();

  // --- running text
  // Runs statements line by line. Each is a step that `undo` takes back, and leaves the scene alone if it
  // fails. Errors are reported; the rest is not run then, unless `keep_going`.
  Outcome run(const text::Place& part, bool keep_going = false);
  Outcome run(const text::SourcePointer& source, bool keep_going = false);
  // Runs statements as a part of the one that is running; what fails is thrown.
  void run_within(const text::Place& part);
  void run_within(const language::Block& commands);
  // The same, but what cannot be parsed or fails is left out, with a warning that says so: the commands that
  // a datafile brings must not keep it from loading.
  // Where a file to read is missing, the rest is left out too. Returns how many were left out.
  long run_what_can_be(const text::Place& part);
  void read(const std::string& path);
  // Replaces the scene by a datafile's and runs the commands at its end. What fails among these is told and
  // left out; the rest runs.
  void load(const std::string& path);
  // Whether the commands at the end of a datafile run: what opens windows elsewhere does nothing then.
  bool is_loading() const;
  // Whether nothing is missing at the text's end: a brace, a quote, an operand.
  bool is_complete(const text::Place& part);

  // --- for a few commands
  // Undoes (or redoes, if negative) this many steps when the running statement is done.
  void request_undo(long steps);
  // Ends the session when the running statement is done.
  void request_quit();
  // Called before each command.
  void begin_command();

 private:
  struct State;
  std::any& memory_of(std::type_index type);
  Outcome run_statement(const language::Block& statement, const std::string& text);
  bool run_or_restore(const language::Block& statement, std::optional<text::Error>& failure);
  void apply_requested_undo();

  std::unique_ptr<State> state_;
};

}  // namespace lamella::session
