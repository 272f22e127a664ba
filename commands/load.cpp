#include "session/session.h"

namespace lamella::session::commands {

namespace {

struct LoadOptions {
  File file;
};

void run(Session& session, const LoadOptions& options) {
  try {
    session.load(options.file.path);
  } catch (const text::Error& error) {
    throw error.placed_at(options.file.place);
  }
}

}  // namespace

extern const Command load_command =
    make_command<LoadOptions>({.name = "load",
                               .summary = "replace the scene by a datafile's",
                               .group = CommandGroup::scene,
                               .brings_names = true},
                              {positional("file", &LoadOptions::file, "a datafile").required()}, run);

}  // namespace lamella::session::commands
