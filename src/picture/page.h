// A page for a web browser in which a scene can be turned: one file, no network.
#pragma once

#include <string>
#include <vector>

#include "picture/camera.h"
#include "picture/drawing.h"
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
};

// The page as HTML.
std::string write_page(const Page& page);

// Bytes in base64.
std::string base64(std::string_view bytes);

}  // namespace lamella::picture
