// Pictures of scenes.
#pragma once

#include <optional>
#include <string>

#include "picture/image.h"
#include "picture/style.h"
#include "picture/view.h"
#include "scene/scene.h"

namespace lamella::picture {

inline constexpr int largest_side = 16384;

struct PictureOptions {
  int width = 1200;
  int height = 900;
  int samples = 5;  // looks at each pixel, 1 to 64: edges are the smoother, the time is the longer
  Style style;
  std::optional<View> view;  // view_of(scene) if none
  bool transparent = false;  // no background
};

// Throws text::Error where there is nothing to draw, a coordinate is not finite, or the size is beyond
// reason.
Image render(const scene::Scene& scene, const PictureOptions& options);

// Renders to a PNG file, which is written whole or not at all.
void show_file(const scene::Scene& scene, const std::string& path, const PictureOptions& options);

}  // namespace lamella::picture
