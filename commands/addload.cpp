#include "datafile/read.h"
#include "scene/append.h"
#include "session/session.h"

namespace lamella::session::commands {

namespace {

struct AddloadOptions {
  File file;
};

void run(Session& session, const AddloadOptions& options) {
  scene::Scene& scene = session.scene();
  if (scene.empty())
    throw text::Error("there is no film to add to", "load a datafile first: load \"cube.fe\"");
  try {
    const datafile::ReadResult result = datafile::read_datafile(options.file.path, &scene.variables);
    for (const text::Diagnostic& warning : result.warnings) session.warn(warning);
    scene::append(scene, result.scene);
  } catch (const text::Error& error) {
    throw error.placed_at(options.file.place);
  }
}

}  // namespace

extern const Command addload_command =
    make_command<AddloadOptions>({.name = "addload",
                                  .summary = "put a datafile's film beside the present one",
                                  .group = CommandGroup::scene,
                                  .brings_names = true},
                                 {positional("file", &AddloadOptions::file, "a datafile").required()}, run);

}  // namespace lamella::session::commands
