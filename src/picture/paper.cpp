// Strokes in ink: as pixels, SVG and PDF.
#include <algorithm>

#include <cairo/cairo-pdf.h>
#include <cairo/cairo-svg.h>
#include <fmt/format.h>

#include "picture/cairo.h"
#include "picture/line_drawing.h"
#include "text/error.h"

namespace lamella::picture {

namespace {

struct Pen {
  double width = 0;  // in heights of the picture
  Colour colour;
};

Pen pen_of(LineKind kind, bool hidden) {
  Pen pen{0.0034, srgb(0x101418)};
  if (kind == LineKind::wire) pen.width = 0.0062;
  if (kind == LineKind::crease) pen.width = 0.0020;
  if (kind == LineKind::none) pen.width = 0.0026;
  if (hidden) pen = {0.5 * pen.width, srgb(0x8b949d)};
  return pen;
}

void draw_stroke(cairo_t* cairo, const Stroke& stroke, double height, double line_width) {
  const Pen pen = pen_of(stroke.kind, stroke.hidden);
  const double width = pen.width * line_width * height;
  cairo_set_line_width(cairo, width);
  set_colour(cairo, pen.colour);
  const double dashes[] = {0.009 * height, 0.007 * height};
  cairo_set_dash(cairo, dashes, stroke.hidden ? 2 : 0, 0);
  cairo_set_line_cap(cairo, stroke.hidden ? CAIRO_LINE_CAP_BUTT : CAIRO_LINE_CAP_ROUND);
  bool first = true;
  for (const Spot& spot : stroke.spots) {
    (first ? cairo_move_to : cairo_line_to)(cairo, spot.x * height, spot.y * height);
    first = false;
  }
  cairo_stroke(cairo);
}

void draw_paper(cairo_t* cairo, const Paper& paper) {
  if (!paper.transparent) {
    set_colour(cairo, paper.background);
    cairo_paint(cairo);
  }
  cairo_set_line_join(cairo, CAIRO_LINE_JOIN_ROUND);
  // What is seen is drawn over what is hidden.
  for (const bool hidden : {true, false}) {
    for (const Stroke& stroke : paper.strokes) {
      if (stroke.hidden == hidden) draw_stroke(cairo, stroke, paper.height, paper.line_width);
    }
  }
  cairo_set_dash(cairo, nullptr, 0, 0);
  if (paper.writing) annotate(cairo, paper.width, paper.height, *paper.writing);
}

cairo_status_t append(void* bytes, const unsigned char* data, unsigned int length) {
  static_cast<std::string*>(bytes)->append(reinterpret_cast<const char*>(data), length);
  return CAIRO_STATUS_SUCCESS;
}

void check(cairo_status_t status) {
  if (status != CAIRO_STATUS_SUCCESS)
    throw text::Error(fmt::format("the drawing cannot be written: {}", cairo_status_to_string(status)));
}

using MakeSurface = cairo_surface_t* (*)(cairo_write_func_t, void*, double, double);

std::string vector_file(const Paper& paper, MakeSurface make) {
  std::string bytes;
  const CairoSurface surface(make(append, &bytes, paper.width, paper.height));
  check(cairo_surface_status(surface.get()));
  {
    const CairoContext cairo(cairo_create(surface.get()));
    draw_paper(cairo.get(), paper);
    check(cairo_status(cairo.get()));
  }
  cairo_surface_finish(surface.get());
  check(cairo_surface_status(surface.get()));
  return bytes;
}

Pixel pixel_of(std::uint32_t code) {
  const std::uint32_t opacity = code >> 24U;
  if (opacity == 0) return {0, 0, 0, 0};
  const auto channel = [&](unsigned shift) {
    return static_cast<std::uint8_t>(std::min<std::uint32_t>(255, ((code >> shift) & 255U) * 255 / opacity));
  };
  return {channel(16), channel(8), channel(0), static_cast<std::uint8_t>(opacity)};
}

}  // namespace

Image paper_image(const Paper& paper) {
  const CairoSurface surface(cairo_image_surface_create(CAIRO_FORMAT_ARGB32, paper.width, paper.height));
  check(cairo_surface_status(surface.get()));
  {
    const CairoContext cairo(cairo_create(surface.get()));
    draw_paper(cairo.get(), paper);
    check(cairo_status(cairo.get()));
  }
  cairo_surface_flush(surface.get());
  Image image(paper.width, paper.height);
  const unsigned char* const bytes = cairo_image_surface_get_data(surface.get());
  const auto stride = static_cast<std::size_t>(cairo_image_surface_get_stride(surface.get()));
  for (int y = 0; y < image.height; ++y) {
    const auto* const row =
        reinterpret_cast<const std::uint32_t*>(bytes + static_cast<std::size_t>(y) * stride);
    for (int x = 0; x < image.width; ++x) image.at(x, y) = pixel_of(row[x]);
  }
  return image;
}

std::string paper_svg(const Paper& paper) {
  return vector_file(paper, cairo_svg_surface_create_for_stream);
}

std::string paper_pdf(const Paper& paper) {
  return vector_file(paper, cairo_pdf_surface_create_for_stream);
}

}  // namespace lamella::picture
