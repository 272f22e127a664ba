#include "picture/show.h"

#include <array>
#include <filesystem>

#include "session/session.h"

namespace lamella::session::commands {

namespace {

struct ShowOptions {
  std::optional<File> file;
  picture::PictureOptions defaults;
  int width = defaults.width;    // pixels
  int height = defaults.height;  // pixels
  int samples = defaults.samples;
  std::optional<std::array<double, 3>> from;
  double zoom = 1;
  bool transparent = false;
};

std::string default_path(const std::string& datafile) {
  return datafile.empty() ? "scene.png"
                          : std::filesystem::path(datafile).filename().replace_extension(".png").string();
}

std::optional<picture::View> view(const scene::Scene& scene, const ShowOptions& options) {
  if (!options.from && options.zoom == 1) return std::nullopt;
  picture::View view = picture::view_of(scene);
  if (options.from) {
    const auto& [x, y, z] = *options.from;
    if (x == 0 && y == 0 && z == 0) throw text::Error("from (0, 0, 0) is no direction");
    view.rotation = picture::looking_from({x, y, z});
  }
  view.zoom = options.zoom;
  return view;
}

void run(Session& session, const ShowOptions& options) {
  const scene::Scene& scene = session.scene();
  if (scene.empty()) throw text::Error("there is nothing to show", "load a datafile first: load cube.fe");
  picture::PictureOptions picture;
  picture.width = options.width;
  picture.height = options.height;
  picture.samples = options.samples;
  picture.transparent = options.transparent;
  picture.view = view(scene, options);
  const std::string path = options.file ? options.file->path : default_path(scene.name);
  try {
    picture::show_file(scene, path, picture);
  } catch (const text::Error& error) {
    throw options.file ? error.placed_at(options.file->place) : error;
  }
  session.tell("picture in {}\n", path);
}

}  // namespace

extern const Command show_command = make_command<ShowOptions>(
    {.name = "show",
     .aliases = {"s"},
     .summary = "draw the scene into a PNG file",
     .group = CommandGroup::output},
    {positional("file", &ShowOptions::file, "the picture; NAME.png in the present folder unless given"),
     option("width", &ShowOptions::width, "in pixels").at_least(1).at_most(picture::largest_side),
     option("height", &ShowOptions::height, "in pixels").at_least(1).at_most(picture::largest_side),
     option("from", &ShowOptions::from, "direction in which the viewer stands, such as (1, -2, 0.5)"),
     option("zoom", &ShowOptions::zoom, "1 fits the whole scene").above(0),
     option("samples", &ShowOptions::samples, "squared: samples in a pixel").at_least(1).at_most(4),
     flag("transparent", &ShowOptions::transparent, "no background")},
    run);

}  // namespace lamella::session::commands
