// Neighbours swapped in a film of one dimension: the string model's T1.
#pragma once

#include <optional>

#include "scene/scene.h"
#include "surgery/event.h"

namespace lamella::surgery {

// A string between two vertices of three strings is turned by a right angle about its middle, in the plane in
// which the strings at its first end lie, and keeps its length. Of the other four, the two on either side of
// where it was meet at the end that has come there; so the cells beside it are no longer neighbours, and
// those beyond its ends are. Nothing is done, and nothing returned, where an end has not three strings or
// does not move freely, or one string joins the two ends a second time. Volumes change a little.
std::optional<Event> swap_at_string(scene::Scene& scene, film::Edge edge);

}  // namespace lamella::surgery
