// A page for a web browser in which a scene can be turned: one file, no network.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "picture/camera.h"
#include "picture/drawing.h"
#include "picture/show.h"
#include "picture/style.h"

namespace lamella::picture {

// A moment of a scene.
struct PageFrame {
  Drawing drawing;
  double time = 0;
};

struct Page {
  std::string title;
  Style style;
  std::uint32_t bodies = 0;
  Camera camera;                  // how the first frame is looked at to begin with
  std::vector<PageFrame> frames;  // more than one are played
  double frames_per_second = 30;
  std::optional<ColourField> field;  // whose colours stand in the legend; its values are not looked at
};

// Adds a moment. The first one decides the title, the style and, without a framing in the options, the view.
void add_frame(Page& page, const scene::Scene& scene, const PictureOptions& options);

// The page as HTML.
std::string write_page(const Page& page);

// Bytes in base64.
std::string base64(std::string_view bytes);

}  // namespace lamella::picture
