#include "picture/show.h"

#include <filesystem>

#include "session/picture_words.h"
#include "session/session.h"
#include "session/terminal_show.h"

namespace lamella::session::commands {

namespace {

struct ShowOptions : PictureWords {
  std::optional<File> file;
};

std::string default_path(const std::string& datafile) {
  return datafile.empty() ? "scene.png"
                          : std::filesystem::path(datafile).filename().replace_extension(".png").string();
}

// What is not made of pixels is made of lines.
picture::PictureOptions wanted_picture(Session& session, const ShowOptions& options, picture::FileKind kind) {
  picture::PictureOptions picture = picture_options(session, options);
  const bool lines_only = kind == picture::FileKind::svg || kind == picture::FileKind::pdf;
  if (!lines_only || picture.style.line_drawing) return picture;
  if (options.style) {
    throw text::Error(options.style->place, "only style=paper can be written as lines",
                      "other styles are pixels: show FILE.png");
  }
  ShowOptions on_paper = options;
  on_paper.style = Word{"paper", {}};
  return picture_options(session, on_paper);
}

void show_in_terminal(Session& session, const ShowOptions& options) {
  const bool own_size = options.size || options.width || options.height;
  session.write(terminal_picture(session, session.scene(), picture_options(session, options), own_size).text);
}

void run(Session& session, const ShowOptions& options) {
  // A datafile that opens a window when it is loaded wants no file written.
  if (session.is_loading() && !options.file) return;
  const scene::Scene& scene = session.scene();
  if (scene.empty()) throw text::Error("there is nothing to show", "load a datafile first: load cube.fe");
  if (!options.file && shows_in_terminal(session)) {
    show_in_terminal(session, options);
    return;
  }
  const std::string path = options.file ? options.file->path : default_path(scene.name);
  try {
    picture::show_file(scene, path, wanted_picture(session, options, picture::file_kind(path)));
  } catch (const text::Error& error) {
    throw options.file ? error.placed_at(options.file->place) : error;
  }
  session.tell("picture in {}\n", path);
}

std::vector<ArgumentOf<ShowOptions>> arguments() {
  std::vector<ArgumentOf<ShowOptions>> table = {
      positional<ShowOptions, std::optional<Elements>>("facets", &ShowOptions::elements,
                                                       "which to draw; all unless given"),
      positional("file", &ShowOptions::file,
                 "the picture; unless given it is drawn in the terminal, or is NAME.png")};
  for (ArgumentOf<ShowOptions>& word : picture_arguments<ShowOptions>()) table.push_back(std::move(word));
  return table;
}

}  // namespace

extern const Command show_command =
    make_command<ShowOptions>({.name = "show",
                               .aliases = {"s"},
                               .summary = "draw the scene, into a file or in the terminal",
                               .group = CommandGroup::output},
                              arguments(), run);

}  // namespace lamella::session::commands
