// Regions after a change of topology: which fell apart, which are new, which are gone.
#pragma once

#include <vector>

#include "scene/scene.h"
#include "surgery/event.h"

namespace lamella::surgery {

// Brings labels and bodies up to date. The sides of films are gathered into shells (sides that face one
// another around an edge); the sign of a shell's volume tells what it is: positive the outer wall of a piece
// of space, negative a cavity in one, nearly zero an open film.
//
//   a region with several outer walls: the largest keeps number and name, each other becomes a new body with
//       a copy of its properties; a target volume is shared by the volumes there are now
//   an outer wall of the outside, of facets among `touched`: a new body, its volume the target
//   a body among `concerned` that has no films any more: marked absent
//
// Cavities stay with the piece around them, or with the largest. Bodies that are open, whose shells carry
// several labels, are left alone.
std::vector<Event> settle_regions(scene::Scene& scene, std::span<const film::Triangle> touched,
                                  std::span<const film::Region> concerned);

// The same after some events, whose regions are concerned. What happened to regions is added to the events.
void settle_regions(scene::Scene& scene, std::vector<Event>& events, std::span<const film::Triangle> touched);

// Makes `gone` part of `stays`: labels change, targets add up; what joins the outside is absent from then on.
// Films between the two stay, with one region on both sides.
void join_regions(scene::Scene& scene, film::Region stays, film::Region gone);

}  // namespace lamella::surgery
