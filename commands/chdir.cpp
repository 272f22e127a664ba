#include <filesystem>

#include "session/session.h"

namespace lamella::session::commands {

namespace {

struct ChdirOptions {
  File folder;
};

void run(Session&, const ChdirOptions& options) {
  std::error_code error;
  std::filesystem::current_path(options.folder.path, error);
  if (!error) return;
  throw text::Error(options.folder.place,
                    fmt::format("cannot go to \"{}\": {}", options.folder.path, error.message()));
}

}  // namespace

extern const Command chdir_command =
    make_command<ChdirOptions>({.name = "chdir",
                                .aliases = {"cd"},
                                .summary = "change the present folder",
                                .group = CommandGroup::session},
                               {positional("folder", &ChdirOptions::folder, "").required()}, run);

}  // namespace lamella::session::commands
