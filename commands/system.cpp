#include <cstdlib>

#include "session/session.h"

namespace lamella::session::commands {

namespace {

struct SystemOptions {
  std::string line;
};

// What is printed so far comes before what the line prints.
void run(Session& session, const SystemOptions& options) {
  session.output().flush();
  const int status = std::system(options.line.c_str());
  constexpr int not_found = 127;
  if (status == -1 || ((status >> 8) & 0xff) == not_found)
    throw text::Error(fmt::format("cannot run \"{}\"", options.line));
}

}  // namespace

extern const Command system_command = make_command<SystemOptions>(
    {.name = "system", .summary = "run a line in the system's shell", .group = CommandGroup::session},
    {positional("line", &SystemOptions::line, "as the shell takes it").required()}, run);

}  // namespace lamella::session::commands
