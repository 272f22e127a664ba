#include "picture/annotations.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "picture/cairo.h"
#include "picture/colour_map.h"

namespace lamella::picture {

namespace {

class Scribe {
 public:
  Scribe(cairo_t* cairo, double width, double height, const Writing& writing)
      : cairo_(cairo), width_(width), height_(height), writing_(writing) {
    const Colour& b = writing.behind;
    dark_ = 0.2126F * b.red + 0.7152F * b.green + 0.0722F * b.blue < 0.2F;
    ink_ = dark_ ? srgb(0xf2f5f8) : srgb(0x1d242b);
    size_ = std::max(9.0, 0.024 * std::min(height, width));
    set_font(cairo_, size_);
    cairo_set_line_join(cairo_, CAIRO_LINE_JOIN_ROUND);
  }

  void write() {
    if (writing_.wanted.labels) labels();
    if (writing_.wanted.legend && writing_.field) colour_bar(*writing_.field);
    if (writing_.wanted.legend && !writing_.field) legend();
    if (writing_.wanted.axes) axes();
    if (writing_.wanted.scale_bar) scale_bar();
  }

 private:
  double text_width(const std::string& text) const {
    cairo_text_extents_t extents;
    cairo_text_extents(cairo_, text.c_str(), &extents);
    return extents.x_advance;
  }

  // With a halo, so that it is read on whatever lies behind. `align` is 0 for text that begins at x, 1 for
  // text that ends there; y is the middle of its height.
  void text(const std::string& text, double x, double y, double align, const Colour& colour) {
    cairo_move_to(cairo_, x - align * text_width(text), y + 0.35 * size_);
    cairo_text_path(cairo_, text.c_str());
    set_colour(cairo_, writing_.behind, 0.75);
    cairo_set_line_width(cairo_, 0.22 * size_);
    cairo_stroke_preserve(cairo_);
    set_colour(cairo_, colour);
    cairo_fill(cairo_);
  }

  void labels() {
    for (const Label& label : writing_.labels) {
      const film::Vec3 at = writing_.camera.project({label.at[0], label.at[1], label.at[2]});
      text(label.text, (at.x + 1) / 2 * width_, (1 - at.y) / 2 * height_, 0.5, ink_);
    }
  }

  void colour_bar(const ColourField& field) {
    const double bar_height = 0.5 * height_;
    const double bar_width = 0.9 * size_;
    const double top = 0.25 * height_;
    const double left = width_ - 6.2 * size_;
    constexpr int steps = 128;
    for (int i = 0; i < steps; ++i) {
      set_colour(cairo_, colour_of(field.map, 1 - (i + 0.5) / steps));
      // Steps overlap, so that no seams are seen between them.
      const double end = std::min(bar_height, (i + 1.5) * bar_height / steps);
      cairo_rectangle(cairo_, left, top + i * bar_height / steps, bar_width, end - i * bar_height / steps);
      cairo_fill(cairo_);
    }
    set_colour(cairo_, ink_);
    cairo_set_line_width(cairo_, 0.05 * size_);
    cairo_rectangle(cairo_, left, top, bar_width, bar_height);
    cairo_stroke(cairo_);
    const double range = field.high - field.low;
    for (const double tick : round_ticks(field.low, field.high, 6)) {
      const double y = range > 0 ? top + bar_height * (field.high - tick) / range : top + bar_height / 2;
      set_colour(cairo_, ink_);
      cairo_move_to(cairo_, left + bar_width, y);
      cairo_line_to(cairo_, left + bar_width + 0.3 * size_, y);
      cairo_stroke(cairo_);
      text(fmt::format("{:.4g}", tick), left + bar_width + 0.5 * size_, y, 0, ink_);
    }
    text(field.title, width_ - 0.8 * size_, top - 1.1 * size_, 1, ink_);
  }

  void legend() {
    const double height = 1.5 * size_;
    const auto rows = static_cast<double>(writing_.legend.size());
    double y = std::max(0.5 * height_ - rows * height / 2, height);
    for (const LegendEntry& entry : writing_.legend) {
      if (y > height_ - height) return;  // more bodies than there is room for
      set_colour(cairo_, entry.colour);
      cairo_rectangle(cairo_, width_ - 6.2 * size_, y - 0.4 * size_, 0.9 * size_, 0.8 * size_);
      cairo_fill(cairo_);
      text(entry.text, width_ - 4.9 * size_, y, 0, ink_);
      y += height;
    }
  }

  // Those that point away from the viewer first.
  void axes() {
    static const std::array<Colour, 3> colours = {srgb(0xd04a3a), srgb(0x3f9b4f), srgb(0x3a6fd0)};
    static constexpr std::array<const char*, 3> names = {"x", "y", "z"};
    const double reach = 3 * size_;
    const double x0 = 4.2 * size_;
    const double y0 = height_ - 4.2 * size_;
    std::array<int, 3> order = {0, 1, 2};
    const Axes& a = writing_.camera.axes;
    std::sort(order.begin(), order.end(), [&](int i, int j) { return a[2][i] < a[2][j]; });
    for (const int k : order) {
      const auto row = static_cast<std::size_t>(k);
      const double x = reach * a[0][k];
      const double y = -reach * a[1][k];
      set_colour(cairo_, colours[row]);
      cairo_set_line_width(cairo_, 0.18 * size_);
      cairo_set_line_cap(cairo_, CAIRO_LINE_CAP_ROUND);
      cairo_move_to(cairo_, x0, y0);
      cairo_line_to(cairo_, x0 + x, y0 + y);
      cairo_stroke(cairo_);
      const double length = std::hypot(x, y);
      const double more = 0.75 * size_ / std::max(length, 0.3 * size_);
      text(names[row], x0 + x * (1 + more), y0 + y * (1 + more), 0.5, colours[row]);
    }
  }

  void scale_bar() {
    const Camera& camera = writing_.camera;
    const film::Vec3 here = camera.project({0, 0, 0});
    const film::Vec3 there = camera.project(camera.axes[0]);
    const double unit = (there.x - here.x) / 2 * width_ / writing_.radius;  // pixels a length of 1
    if (!(unit > 0)) return;
    const double most = 0.25 * width_ / unit;
    double length = std::pow(10.0, std::floor(std::log10(most)));
    for (const double factor : {5.0, 2.0}) {
      if (factor * length > most) continue;
      length *= factor;
      break;
    }
    const double right = width_ - 1.5 * size_;
    const double y = height_ - 1.6 * size_;
    const double left = right - length * unit;
    set_colour(cairo_, ink_);
    cairo_set_line_width(cairo_, 0.16 * size_);
    cairo_set_line_cap(cairo_, CAIRO_LINE_CAP_BUTT);
    cairo_move_to(cairo_, left, y - 0.3 * size_);
    cairo_line_to(cairo_, left, y);
    cairo_line_to(cairo_, right, y);
    cairo_line_to(cairo_, right, y - 0.3 * size_);
    cairo_stroke(cairo_);
    text(fmt::format("{:g}", length), (left + right) / 2, y - 0.9 * size_, 0.5, ink_);
  }

  cairo_t* cairo_;
  double width_;
  double height_;
  const Writing& writing_;
  bool dark_ = false;
  Colour ink_;
  double size_ = 10;
};

// A byte of an image under one of writing, whose channels are multiplied by its opacity.
std::uint8_t under(std::uint32_t written, std::uint32_t opacity, double behind, double behind_opacity,
                   double whole) {
  const double light = written + behind * behind_opacity / 255 * (255 - opacity) / 255;
  return static_cast<std::uint8_t>(std::clamp(std::lround(light * 255 / whole), 0L, 255L));
}

}  // namespace

void annotate(cairo_t* cairo, double width, double height, const Writing& writing) {
  Scribe(cairo, width, height, writing).write();
}

void annotate(Image& image, const Writing& writing) {
  const CairoSurface surface(cairo_image_surface_create(CAIRO_FORMAT_ARGB32, image.width, image.height));
  const CairoContext cairo(cairo_create(surface.get()));
  annotate(cairo.get(), image.width, image.height, writing);
  cairo_surface_flush(surface.get());
  const unsigned char* const bytes = cairo_image_surface_get_data(surface.get());
  const auto stride = static_cast<std::size_t>(cairo_image_surface_get_stride(surface.get()));
  for (int y = 0; y < image.height; ++y) {
    const auto* const row =
        reinterpret_cast<const std::uint32_t*>(bytes + static_cast<std::size_t>(y) * stride);
    for (int x = 0; x < image.width; ++x) {
      const std::uint32_t code = row[x];
      const std::uint32_t opacity = code >> 24U;
      if (opacity == 0) continue;
      Pixel& pixel = image.at(x, y);
      const double behind = pixel.opacity;
      const double whole = opacity + behind * (255 - opacity) / 255;
      pixel.red = under((code >> 16U) & 255U, opacity, pixel.red, behind, whole);
      pixel.green = under((code >> 8U) & 255U, opacity, pixel.green, behind, whole);
      pixel.blue = under(code & 255U, opacity, pixel.blue, behind, whole);
      pixel.opacity = static_cast<std::uint8_t>(std::lround(whole));
    }
  }
}

}  // namespace lamella::picture
