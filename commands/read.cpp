#include "session/session.h"

namespace lamella::session::commands {

namespace {

struct ReadOptions {
  File file;
};

void run(Session& session, const ReadOptions& options) {
  try {
    session.read(options.file.path);
  } catch (const text::Error& error) {
    throw error.placed_at(options.file.place);
  }
}

}  // namespace

extern const Command read_command =
    make_command<ReadOptions>({.name = "read",
                               .summary = "run the commands in a file",
                               .group = CommandGroup::session,
                               .brings_names = true},
                              {positional("file", &ReadOptions::file, "a script").required()}, run);

}  // namespace lamella::session::commands
