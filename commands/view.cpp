#include <cmath>

#include "picture/view_words.h"
#include "session/picture_words.h"
#include "session/session.h"
#include "text/whole_file.h"

namespace lamella::session::commands {

namespace {

struct ViewOptions {
  std::string name;
  std::optional<std::array<double, 3>> from;
  std::optional<std::array<double, 3>> rotate;
  std::optional<std::array<double, 2>> pan;
  std::optional<double> zoom;
  std::optional<double> lens;
  bool fit = false;
  bool reset = false;
  std::optional<File> save;
  std::optional<File> load;
};

void tell(Session& session, const picture::View& view) {
  film::Vec3 from = picture::axes(view.rotation)[2];
  for (double* const part : {&from.x, &from.y, &from.z}) *part = std::round(*part * 1e12) / 1e12 + 0.0;
  session.print("from ({:.4g}, {:.4g}, {:.4g}) zoom {:.4g} pan ({:.4g}, {:.4g}) lens {:.4g}\n", from.x,
                from.y, from.z, view.zoom, view.right, view.up, view.field_of_view);
}

void turn(picture::View& view, const ViewOptions& options) {
  if (!options.name.empty()) view.rotation = picture::rotation_named(options.name);
  if (options.from) {
    const auto& [x, y, z] = *options.from;
    if (x == 0 && y == 0 && z == 0) throw text::Error("from (0, 0, 0) is no direction");
    view.rotation = picture::looking_from({x, y, z});
  }
  if (options.rotate) {
    const auto& [right, up, roll] = *options.rotate;
    view.rotation = picture::turned(view.rotation, right, up, roll);
  }
  if (options.fit) {
    view.zoom = 1;
    view.right = view.up = 0;
  }
  if (options.zoom) view.zoom *= *options.zoom;
  if (options.pan) {
    view.right += (*options.pan)[0];
    view.up += (*options.pan)[1];
  }
  if (options.lens) view.field_of_view = *options.lens;
}

void run(Session& session, const ViewOptions& options) {
  std::optional<picture::View>& kept = session.memory<ViewMemory>().view;
  picture::View view = present_view(session, kept);
  const picture::View before = view;
  if (options.load) {
    try {
      view = picture::read_view(text::read_whole_file(options.load->path));
    } catch (const text::Error& error) {
      throw error.placed_at(options.load->place);
    }
  }
  turn(view, options);
  if (options.save) {
    try {
      text::write_whole_file(options.save->path, picture::write_view(view));
    } catch (const text::Error& error) {
      throw error.placed_at(options.save->place);
    }
    session.tell("view in {}\n", options.save->path);
  }
  if (options.reset) {
    kept.reset();
  } else if (options.load || picture::write_view(view) != picture::write_view(before)) {
    kept = view;
  } else if (!options.save) {
    tell(session, view);
  }
}

}  // namespace

extern const Command view_command = make_command<ViewOptions>(
    {.name = "view", .summary = "choose from where pictures are taken", .group = CommandGroup::output},
    {positional("name", &ViewOptions::name, "one of the views by name").one_of(picture::view_names()),
     option("from", &ViewOptions::from, "direction in which the viewer stands, such as (1, -2, 0.5)"),
     option("rotate", &ViewOptions::rotate, "degrees to the right, upward and counterclockwise"),
     option("zoom", &ViewOptions::zoom, "so many times larger than now").above(0),
     option("pan", &ViewOptions::pan, "to the right and upward, in heights of the picture"),
     option("lens", &ViewOptions::lens, "degrees that the picture spans; 0 for a parallel projection")
         .at_least(0)
         .at_most(120),
     flag("fit", &ViewOptions::fit, "the whole scene in the middle again"),
     flag("reset", &ViewOptions::reset, "the view that suits the scene"),
     option("save", &ViewOptions::save, "write the view to a file"),
     option("load", &ViewOptions::load, "take the view from a file")},
    run);

}  // namespace lamella::session::commands
