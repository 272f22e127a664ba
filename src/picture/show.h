// Pictures of scenes.
#pragma once

#include <optional>
#include <string>

#include "picture/annotations.h"
#include "picture/camera.h"
#include "picture/content.h"
#include "picture/image.h"
#include "picture/style.h"
#include "picture/view.h"
#include "scene/scene.h"

namespace lamella::picture {

inline constexpr int largest_side = 16384;

// How a scene is placed in a picture, to be kept from one picture to the next.
struct Framing {
  Surrounding surrounding;
  Camera camera;
};

struct PictureOptions {
  int width = 1200;
  int height = 900;
  int samples = 5;  // looks at each pixel, 1 to 64: edges are the smoother, the time is the longer
  Style style;
  std::optional<View> view;  // view_of(scene) if none
  Content content;
  Annotations annotations;
  bool shadow = false;             // on the ground under the scene
  bool transparent = false;        // no background
  std::optional<Framing> framing;  // instead of the view: as in another picture
  double line_width = 1;           // of line drawings, as a factor; light has it in the style
};

// Throws text::Error where there is nothing to draw, a coordinate is not finite, or the size is beyond
// reason.
Image render(const scene::Scene& scene, const PictureOptions& options);

// How `render` places this scene. Throws as it does.
Framing framing_of(const scene::Scene& scene, const PictureOptions& options);

// By a path's ending: .png (or none), .svg and .pdf for line drawings, .html for a page (page.h).
enum class FileKind { png, svg, pdf, html };
FileKind file_kind(const std::string& path);  // text::Error for other endings

// The bytes of a file of this kind.
std::string encode_picture(const scene::Scene& scene, FileKind kind, const PictureOptions& options);

// Renders to a file, which is written whole or not at all.
void show_file(const scene::Scene& scene, const std::string& path, const PictureOptions& options);

}  // namespace lamella::picture
