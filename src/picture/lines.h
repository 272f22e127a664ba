// The lines of a film that are drawn: Plateau borders, rims, wires, creases; and the points where borders
// meet.
#pragma once

#include <span>

#include "picture/drawing.h"

namespace lamella::picture {

enum class LineKind { none, border, rim, wire };

// A wire is fixed or carries no film; a border joins three or more films; a rim ends one. A fixed edge inside
// a patch of fixed facets is part of the patch, not a line.
LineKind line_kind(const film::Film& film, film::Edge e);

// Appends the tubes and balls of all lines and of the edges at which a film bends sharply.
void add_lines(Drawing& drawing, const film::Film& film, std::span<const film::Edge> creases,
               const Style& style);

}  // namespace lamella::picture
