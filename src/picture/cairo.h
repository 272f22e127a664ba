// Cairo's objects as values that free themselves.
#pragma once

#include <memory>

#include <cairo/cairo.h>

#include "picture/colour.h"

namespace lamella::picture {

struct CairoFree {
  void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
  void operator()(cairo_t* context) const { cairo_destroy(context); }
};
using CairoSurface = std::unique_ptr<cairo_surface_t, CairoFree>;
using CairoContext = std::unique_ptr<cairo_t, CairoFree>;

inline void set_colour(cairo_t* cairo, const Colour& colour, double opacity = 1) {
  cairo_set_source_rgba(cairo, srgb_byte(colour.red) / 255.0, srgb_byte(colour.green) / 255.0,
                        srgb_byte(colour.blue) / 255.0, opacity);
}

inline void set_font(cairo_t* cairo, double size) {
  cairo_select_font_face(cairo, "sans-serif", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(cairo, size);
}

}  // namespace lamella::picture
