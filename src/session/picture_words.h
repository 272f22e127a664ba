// What a picture is to look like, as `show`, `record` and `watch` are told.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "picture/show.h"
#include "session/arguments.h"

namespace lamella::session {

class Session;

// Options with the words of a picture derive from this.
struct PictureWords {
  std::optional<Elements> elements;
  std::optional<Word> size;
  std::optional<int> width;
  std::optional<int> height;
  std::optional<Word> style;
  std::optional<Word> background;
  bool transparent = false;
  bool shadow = false;
  std::optional<int> samples;
  std::optional<File> view;
  std::optional<std::array<double, 3>> from;
  std::optional<std::array<double, 3>> rotate;
  std::optional<double> zoom;
  std::optional<std::array<double, 2>> pan;
  std::optional<double> lens;
  std::optional<Field> color;
  std::optional<std::array<double, 2>> range;
  std::string map = "viridis";
  std::optional<Field> thickness;
  std::optional<std::array<double, 2>> drain;
  std::optional<std::array<double, 4>> clip;
  double explode = 0;
  double line_width = 1;
  std::optional<double> opacity;
  std::optional<double> iridescence;
  bool legend = false;
  bool axes = false;
  bool scale_bar = false;
  bool labels = false;
};

// The picture that these words ask for, of the session's scene as it is now.
picture::PictureOptions picture_options(Session& session, const PictureWords& words);

// The view that `view` has set, or else the one that suits the scene.
picture::View present_view(const Session& session, const std::optional<picture::View>& set);

// What `view` leaves for pictures to come.
struct ViewMemory {
  std::optional<picture::View> view;
};

// The part of a table of arguments that belongs to PictureWords.
template <class Options>
std::vector<ArgumentOf<Options>> picture_arguments() {
  const auto own = [](std::string name, auto PictureWords::*member, std::string help) {
    using Member = std::remove_reference_t<decltype(std::declval<PictureWords>().*member)>;
    return option<Options, Member>(std::move(name), static_cast<Member Options::*>(member), std::move(help));
  };
  std::vector<ArgumentOf<Options>> table;
  const auto add = [&](ArgumentOf<Options> argument) { table.push_back(std::move(argument)); };
  using W = PictureWords;
  add(own("size", &W::size, "in pixels, as in size=1600x1200"));
  add(own("width", &W::width, "in pixels").at_least(1).at_most(picture::largest_side));
  add(own("height", &W::height, "in pixels").at_least(1).at_most(picture::largest_side));
  add(own("style", &W::style, "film, glass, paper, wire, regions or flat"));
  add(own("background", &W::background, "a colour: white, black, lightblue, #rrggbb; or none"));
  add(own("transparent", &W::transparent, "no background"));
  add(own("shadow", &W::shadow, "a soft shadow on the ground"));
  add(own("samples", &W::samples, "looks at each pixel").at_least(1).at_most(64));
  add(own("view", &W::view, "front, back, left, right, top, bottom, corner or a file of view save"));
  add(own("from", &W::from, "direction in which the viewer stands, such as (1, -2, 0.5)"));
  add(own("rotate", &W::rotate, "degrees to the right, upward and counterclockwise"));
  add(own("zoom", &W::zoom, "1 fits the whole scene").above(0));
  add(own("pan", &W::pan, "to the right and upward, in heights of the picture"));
  add(own("lens", &W::lens, "degrees that the picture spans; 0 for a parallel projection")
          .at_least(0)
          .at_most(120));
  add(own("color", &W::color, "a formula of facets, vertices or edges, shown as colours"));
  add(own("range", &W::range, "the numbers at the ends of the colours; all that occur unless given"));
  add(own("map", &W::map, "the colours").one_of({"viridis", "diverging", "grey"}));
  add(own("thickness", &W::thickness, "of the films, in nanometres, a formula; draining unless given"));
  add(own("drain", &W::drain, "thickness at the top and at the bottom, in nanometres"));
  add(own("clip", &W::clip, "(a, b, c, d) cuts away a x + b y + c z > d"));
  add(own("explode", &W::explode, "moves bodies out by this part of their distance from the middle")
          .at_least(0)
          .at_most(100));
  add(own("line_width", &W::line_width, "of borders and wires, 1 as usual").above(0).at_most(20));
  add(own("opacity", &W::opacity, "how much a film reflects, seen head on").at_least(0).at_most(1));
  add(own("iridescence", &W::iridescence, "from 0, grey, to 1, the full colours of interference")
          .at_least(0)
          .at_most(1));
  add(own("legend", &W::legend, "the colours and what they mean"));
  add(own("axes", &W::axes, "the directions of x, y and z"));
  add(own("scale_bar", &W::scale_bar, "a length"));
  add(own("labels", &W::labels, "the numbers of bodies"));
  return table;
}

}  // namespace lamella::session
