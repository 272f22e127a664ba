// The lines of a film that are drawn: Plateau borders, rims, wires, creases; and the points where borders
// meet.
#pragma once

#include <span>

#include "picture/drawing.h"

namespace lamella::picture {

// A wire is fixed or carries no film; a border joins three or more films; a rim ends one. A fixed edge inside
// a patch of fixed facets is part of the patch, not a line.
LineKind line_kind(const film::Film& film, film::Edge e);

// Appends the tubes and balls of all lines and of the edges at which a film bends sharply. `facets` tells
// which facets are drawn, one a row (empty: all); an edge of others only is left out.
void add_lines(Drawing& drawing, const film::Film& film, std::span<const film::Edge> creases,
               const Style& style, std::span<const std::uint8_t> facets = {});

}  // namespace lamella::picture
