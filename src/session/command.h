// A command: one file commands/NAME.cpp with one constant `NAME_command` that says all there is to say about
// it.
//
//   namespace lamella::session::commands {
//   namespace {
//
//   struct EvolveOptions {
//     long steps = 1;
//     std::optional<double> dt;  // s; from a stability bound unless given
//   };
//
//   void run(Session& session, const EvolveOptions& options) { ... }
//
//   }  // namespace
//
//   extern const Command evolve_command = make_command<EvolveOptions>(
//       {.name = "evolve", .summary = "move the film by hyperbolic flow", .group = CommandGroup::motion},
//       {positional("steps", &EvolveOptions::steps, "number of steps").at_least(0),
//        option("dt", &EvolveOptions::dt, "step size in s").above(0).or_word("auto")},
//       run);
//
//   }  // namespace lamella::session::commands
//
// CMake writes the table of all commands from the files in commands/. A command that throws text::Error
// (without a place it is shown at the command's word) leaves the scene as it was before the whole statement
// typed at the prompt.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "session/arguments.h"

namespace lamella::session {

class Session;

// Where `help` lists it.
enum class CommandGroup : std::uint8_t { motion, mesh, measure, scene, output, language, session };

struct CommandInfo {
  std::string name;                       // as in commands/NAME.cpp
  std::vector<std::string> aliases = {};  // single letters are told apart by case, words are not
  std::string summary;                    // one line, no full stop
  CommandGroup group = CommandGroup::scene;
  bool brings_names = false;  // may define variables or procedures when it runs (load, read)
};

struct Given {
  const Argument* argument = nullptr;
  GivenValue value;
};

struct Command : CommandInfo {
  std::vector<Argument> arguments;
  std::function<void(Session& session, std::span<const Given> given)> run;
};

template <class Options>
Command make_command(CommandInfo info, std::vector<ArgumentOf<Options>> arguments,
                     void (*run)(Session& session, const Options& options)) {
  Command command{std::move(info), {}, {}};
  for (ArgumentOf<Options>& argument : arguments) command.arguments.push_back(std::move(argument));
  command.run = [run](Session& session, std::span<const Given> given) {
    Options options;
    for (const Given& each : given) each.argument->store(&options, each.value);
    run(session, options);
  };
  return command;
}

// A command that takes nothing.
inline Command make_command(CommandInfo info, void (*run)(Session& session)) {
  return Command{std::move(info), {}, [run](Session& session, std::span<const Given>) { run(session); }};
}

// In the order of their names. Written by CMake from the files in commands/.
std::span<const Command* const> command_table();

// `evolve [steps] [dt number|auto]`
std::string usage(const Command& command);
// One line for each argument, with its help.
std::string argument_help(const Command& command);

}  // namespace lamella::session
