#include "picture/show.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

#include <fmt/format.h>

#include "picture/drawing.h"
#include "picture/explode.h"
#include "picture/light.h"
#include "picture/line_drawing.h"
#include "picture/page.h"
#include "picture/png.h"
#include "picture/unwrapped.h"
#include "text/error.h"
#include "text/whole_file.h"

namespace lamella::picture {

namespace {

constexpr int most_samples = 64;

void refuse_bad_size(const PictureOptions& options) {
  for (const int side : {options.width, options.height}) {
    if (side >= 1 && side <= largest_side) continue;
    throw text::Error(fmt::format("a picture cannot be {} by {} pixels", options.width, options.height),
                      fmt::format("width and height may be 1 to {}", largest_side));
  }
  if (options.samples < 1 || options.samples > most_samples) {
    throw text::Error(fmt::format("a picture cannot have {} samples a pixel", options.samples),
                      fmt::format("1 to {} are possible", most_samples));
  }
}

[[noreturn]] void refuse_nothing(const PictureOptions& options) {
  if (options.content.clip) throw text::Error("the clipping plane cuts everything away");
  if (!options.content.facets.empty())
    throw text::Error("there is nothing to draw: no facet was picked out, and there are no wires");
  throw text::Error("there is nothing to draw: the scene has no facet and no edge",
                    "load a datafile first, e.g. load datafiles/double_bubble.fe");
}

Writing writing(const scene::Scene& scene, const PictureOptions& options, const Drawing& drawing,
                const Camera& camera) {
  Writing writing{options.annotations, camera, drawing.radius, options.content.field, {}, {}, {}};
  writing.behind = mix(options.style.background_top, options.style.background_bottom, 0.5F);
  const std::vector<film::Vec3> centres = exploded_centres(scene, options.content.explode);
  for (std::uint32_t b = 1; b < centres.size(); ++b) {
    if (scene.bodies[b - 1].absent) continue;
    const std::string number = fmt::format("{}", b);
    writing.labels.push_back({drawing.place(centres[b]), number});
    if (options.style.film.by_region)
      writing.legend.push_back({"body " + number, region_colour(film::Region{b})});
  }
  return writing;
}

// Everything that a picture is made from.
struct Prepared {
  Drawing drawing;
  Camera camera;
  double aspect = 1;
};

Prepared prepare(const scene::Scene& scene, const PictureOptions& options) {
  refuse_bad_size(options);
  Content content = options.content;
  if (options.framing) content.surrounding = options.framing->surrounding;
  Prepared prepared{draw(scene, options.style, content), {}, 1};
  if (prepared.drawing.empty()) refuse_nothing(options);
  prepared.aspect = static_cast<double>(options.width) / options.height;
  // Films that are shrunk to a point are still looked at from a distance.
  const double around = std::max(prepared.drawing.largest_tube(), 1e-3);
  if (options.framing) {
    prepared.camera = options.framing->camera;
    set_depths(prepared.camera, prepared.drawing.outline(), around);
  } else {
    const View view = options.view ? *options.view : view_of(scene);
    prepared.camera = fit_camera(prepared.drawing.outline(), around, view, prepared.aspect);
  }
  return prepared;
}

Paper paper(const scene::Scene& scene, const PictureOptions& options) {
  const Prepared prepared = prepare(scene, options);
  Paper paper;
  paper.strokes = find_strokes(prepared.drawing, prepared.camera, prepared.aspect);
  paper.width = options.width;
  paper.height = options.height;
  paper.background = options.style.background_top;
  paper.transparent = options.transparent;
  paper.line_width = options.line_width;
  if (options.annotations.any()) paper.writing = writing(scene, options, prepared.drawing, prepared.camera);
  return paper;
}

std::string lower_extension(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return extension;
}

}  // namespace

Framing framing_of(const scene::Scene& scene, const PictureOptions& options) {
  if (scene.film.periodic()) return unwrapped(scene, options, framing_of);
  const Prepared prepared = prepare(scene, options);
  return {{prepared.drawing.middle, prepared.drawing.radius}, prepared.camera};
}

FileKind file_kind(const std::string& path) {
  const std::string extension = lower_extension(path);
  if (extension == ".png" || extension.empty()) return FileKind::png;
  if (extension == ".svg") return FileKind::svg;
  if (extension == ".pdf") return FileKind::pdf;
  if (extension == ".html") return FileKind::html;
  throw text::Error(fmt::format("pictures are not written as \"{}\"", extension),
                    "a picture is a .png, a line drawing also .svg or .pdf, and .html a page to turn it in");
}

Image render(const scene::Scene& scene, const PictureOptions& options) {
  if (scene.film.periodic()) return unwrapped(scene, options, render);
  if (options.style.line_drawing) return paper_image(paper(scene, options));
  const Prepared prepared = prepare(scene, options);
  Image image(options.width, options.height);
  paint_light(image, prepared.drawing, prepared.camera, options.style, options.samples, options.transparent,
              options.shadow);
  if (options.annotations.any()) annotate(image, writing(scene, options, prepared.drawing, prepared.camera));
  return image;
}

std::string encode_picture(const scene::Scene& scene, FileKind kind, const PictureOptions& options) {
  if (scene.film.periodic()) {
    return unwrapped(scene, options, [&](const scene::Scene& plain, const PictureOptions& plain_options) {
      return encode_picture(plain, kind, plain_options);
    });
  }
  if (kind == FileKind::png) return encode_png(render(scene, options));
  if (kind == FileKind::html) {
    Page page;
    add_frame(page, scene, options);
    return write_page(page);
  }
  const Paper drawing = paper(scene, options);
  return kind == FileKind::svg ? paper_svg(drawing) : paper_pdf(drawing);
}

void show_file(const scene::Scene& scene, const std::string& path, const PictureOptions& options) {
  text::write_whole_file(path, encode_picture(scene, file_kind(path), options));
}

}  // namespace lamella::picture
