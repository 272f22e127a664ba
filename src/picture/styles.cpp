#include "picture/styles.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "text/error.h"
#include "text/suggest.h"

namespace lamella::picture {

namespace {

Style film() {
  return {};
}

// Blown glass before a dark wall: no colours of interference, bright edges.
Style glass() {
  Style style;
  style.background_top = srgb(0x33404d);
  style.background_bottom = srgb(0x0e1318);
  style.surroundings = {srgb(0xdfe9f2), srgb(0x7e93a5), srgb(0x27323c)};
  style.film.opacity = 0.05;
  style.film.grazing = 0.95;
  style.film.falloff = 3.2;
  style.film.iridescence = 0;
  style.film.highlights = 1.5;
  style.border = {srgb(0xa9bccb), 0.0050, 1.4};
  style.rim = style.border;
  style.wire = {srgb(0x8d949b), 0.011, 1.5};
  style.haze = 0.2;
  return style;
}

Style paper() {
  Style style;
  style.line_drawing = true;
  style.background_top = style.background_bottom = srgb(0xffffff);
  return style;
}

// The mesh itself; films are a hint.
Style wire() {
  Style style;
  style.background_top = style.background_bottom = srgb(0xffffff);
  style.surroundings = {srgb(0xe8eef5), srgb(0xc9d4df), srgb(0xa9b6c4)};
  style.film.opacity = 0.05;
  style.film.grazing = 0.25;
  style.film.iridescence = 0;
  style.film.highlights = 0;
  style.mesh = {srgb(0x6a7b8c), 0.0011, 0};
  style.border = {srgb(0x1c4f8a), 0.0048, 0.2};
  style.rim = {srgb(0x2f7d5b), 0.0048, 0.2};
  style.wire = {srgb(0xa5532a), 0.0065, 0.3};
  style.crease = {srgb(0x6a7b8c), 0.0011, 0};
  style.haze = 0.55;
  return style;
}

// Each bubble in its own colour, seen from outside.
Style regions() {
  Style style;
  style.background_top = style.background_bottom = srgb(0xffffff);
  style.surroundings = {srgb(0xf4f7fa), srgb(0xc3ccd6), srgb(0x8d98a5)};
  style.film.by_region = true;
  style.film.paint = srgb(0xaab4be);
  style.film.opacity = 0.05;
  style.film.grazing = 0.4;
  style.film.iridescence = 0;
  style.film.highlights = 0.5;
  style.film.tint_opacity = 0.42;
  style.border = {srgb(0x3b4550), 0.0052, 0.4};
  style.rim = style.border;
  style.haze = 0.1;
  return style;
}

// Facets as the flat, opaque triangles that they are.
Style flat() {
  Style style;
  style.background_top = style.background_bottom = srgb(0xffffff);
  style.surroundings = {srgb(0xffffff), srgb(0xb8c0c8), srgb(0x6e7882)};
  style.film.faceted = true;
  style.film.paint = srgb(0xe9e4d6);
  style.film.opacity = 0;
  style.film.grazing = 0;
  style.film.iridescence = 0;
  style.film.highlights = 0;
  style.film.tint_opacity = 1;
  style.mesh = {srgb(0x4d565f), 0.0010, 0};
  style.border = {srgb(0x1c4f8a), 0.0050, 0.2};
  style.rim = style.border;
  style.crease = style.mesh;
  style.haze = 0;
  return style;
}

}  // namespace

const std::vector<NamedStyle>& named_styles() {
  static const std::vector<NamedStyle> styles = {
      {"film", "soap films in the colours of interference", film},
      {"glass", "clear glass before a dark wall", glass},
      {"paper", "a line drawing with hidden lines", paper},
      {"wire", "the mesh", wire},
      {"regions", "each bubble in a colour of its own", regions},
      {"flat", "opaque flat facets", flat},
  };
  return styles;
}

std::vector<std::string> style_names() {
  std::vector<std::string> names;
  for (const NamedStyle& style : named_styles()) names.emplace_back(style.name);
  return names;
}

Style style_named(std::string_view name) {
  for (const NamedStyle& style : named_styles()) {
    if (style.name == name) return style.make();
  }
  const std::vector<std::string> names = style_names();
  const std::string near = text::did_you_mean(name, names);
  throw text::Error(fmt::format("there is no style \"{}\"", name),
                    near.empty() ? fmt::format("styles are {}", fmt::join(names, ", ")) : near);
}

}  // namespace lamella::picture
