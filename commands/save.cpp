#include <filesystem>

#include "datafile/write.h"
#include "session/session.h"
#include "text/whole_file.h"

namespace lamella::session::commands {

namespace {

struct SaveOptions {
  std::optional<File> file;
};

// Beside the datafile, never over it.
std::string default_path(const std::string& datafile) {
  return datafile.empty() ? "scene.dmp"
                          : std::filesystem::path(datafile).filename().replace_extension(".dmp").string();
}

void run(Session& session, const SaveOptions& options) {
  const std::string path = options.file ? options.file->path : default_path(session.scene().name);
  try {
    text::write_whole_file(path, datafile::write_datafile(session.scene()));
  } catch (const text::Error& error) {
    throw options.file ? error.placed_at(options.file->place) : error;
  }
  session.tell("saved as {}\n", path);
  const std::optional<scene::Air>& air = session.scene().forces.air;
  if (air && air->velocity)
    session.warn("the flow of the air is not saved: a run that goes on from the file begins with still air");
}

}  // namespace

extern const Command save_command = make_command<SaveOptions>(
    {.name = "save",
     .aliases = {"d", "dump"},
     .summary = "write the scene as a datafile",
     .group = CommandGroup::scene},
    {positional("file", &SaveOptions::file, "the datafile; NAME.dmp in the present folder unless given")},
    run);

}  // namespace lamella::session::commands
