#include "session/session.h"

namespace lamella::session::commands {

namespace {

struct ExecOptions {
  std::string commands;
};

void run(Session& session, const ExecOptions& options) {
  const text::SourcePointer source = text::make_source("exec", options.commands);
  session.run_within({source, 0, static_cast<std::uint32_t>(source->content.size())});
}

}  // namespace

extern const Command exec_command =
    make_command<ExecOptions>({.name = "exec",
                               .summary = "run the commands in a string",
                               .group = CommandGroup::language,
                               .brings_names = true},
                              {positional("commands", &ExecOptions::commands, "a string").required()}, run);

}  // namespace lamella::session::commands
