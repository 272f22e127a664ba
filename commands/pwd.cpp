#include <filesystem>

#include "session/session.h"

namespace lamella::session::commands {

namespace {

void run(Session& session) {
  session.print("{}\n", std::filesystem::current_path().string());
}

}  // namespace

extern const Command pwd_command =
    make_command({.name = "pwd", .summary = "print the present folder", .group = CommandGroup::session}, run);

}  // namespace lamella::session::commands
