// A session: the scene, and everything that lives as long as the program does.
//
// Commands see of it: the scene (which they may change as they like), where to write, the monitor of long
// computations, counters, random numbers, and the values of expressions they were given unevaluated.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "language/evaluate.h"
#include "scene/monitor.h"
#include "scene/scene.h"
#include "session/command.h"
#include "text/error.h"

namespace lamella::session {

class Session {
 public:
  explicit Session(std::span<const Command* const> commands);
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  // --- the scene. To change it in a command needs no ceremony: a failure takes everything back.
  scene::Scene& scene();
  const scene::Scene& scene() const;

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
  // To the standard error output, never redirected.
  void warn(const text::Diagnostic& warning);
  void warn(std::string message);

  // --- long computations: asks to stop on Ctrl-C, draws the progress line
  scene::Monitor& monitor();

  // --- small things
  // Counters such as `refine_count`, readable as variables after a command has set them.
  double& counter(std::string_view name);
  std::mt19937_64& random();

  // --- expressions given unevaluated
  language::Evaluation& evaluation();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace lamella::session
