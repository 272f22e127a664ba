// Films that break.
#pragma once

#include <optional>

#include "scene/scene.h"
#include "surgery/event.h"

namespace lamella::surgery {

// The smooth sheet that a facet belongs to: all facets to be reached without crossing a border, a rim or a
// wire.
std::vector<film::Triangle> sheet_of(const film::Film& film, film::Triangle facet);

// Takes out the whole sheet of a facet. The regions on its two sides become one: the outside, if one of them
// is, else the larger in number of facets; a target volume is the sum of both. Borders that are left with one
// film become its rim; fixed facets do not break. Nothing where the sheet is fixed.
std::optional<Event> burst_sheet(scene::Scene& scene, film::Triangle facet);

// All films of a body to one of its neighbours go, and with them the body: the outside, if it is a neighbour,
// else the one with which it shares the largest area. Nothing where the body has no films.
std::optional<Event> burst_body(scene::Scene& scene, film::Region body);

}  // namespace lamella::surgery
