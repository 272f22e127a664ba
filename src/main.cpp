#include <CLI/CLI.hpp>

#include "session/program.h"

namespace {

using lamella::session::Input;

// -e and -f in the order in which they were given.
std::vector<Input> inputs_in_order(const CLI::App& app, const std::vector<std::string>& commands,
                                   const std::vector<std::string>& scripts, const CLI::Option* script_option,
                                   const CLI::Option* command_option) {
  std::vector<Input> inputs;
  std::size_t command = 0;
  std::size_t script = 0;
  for (const CLI::Option* const option : app.parse_order()) {
    if (option == command_option) inputs.push_back({false, commands.at(command++)});
    if (option == script_option) inputs.push_back({true, scripts.at(script++)});
  }
  return inputs;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Lamella: soap films and foams at your fingertips.", "lamella");
  lamella::session::ProgramOptions options;
  std::vector<std::string> commands;
  std::vector<std::string> scripts;
  app.add_option("datafile", options.datafile, "datafile to load")->type_name("FILE.fe");
  CLI::Option* const command_option =
      app.add_option("-e", commands, "commands to run")->type_name("COMMANDS");
  CLI::Option* const script_option =
      app.add_option("-f", scripts, "file of commands to run")->type_name("SCRIPT");
  for (CLI::Option* const option : {command_option, script_option}) {
    option->allow_extra_args(false)->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  }
  app.add_flag("-i,--interactive", options.interactive, "go on at the prompt when the commands are done");
  app.add_flag("-q,--quiet", options.quiet, "print only what commands ask for");
  app.add_flag("--keep-going", options.keep_going, "run the rest when a command fails");
  app.set_version_flag("--version", "lamella " + std::string(lamella::session::version()));
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    const int code = app.exit(error);
    return code == 0 ? lamella::session::success : lamella::session::unusable;
  }
  options.inputs = inputs_in_order(app, commands, scripts, script_option, command_option);
  return lamella::session::run_program(options, lamella::session::command_table());
}
