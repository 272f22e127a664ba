// A mesh made anew for a film whose own is past mending.
#pragma once

#include "scene/scene.h"

namespace lamella::evolution {

// Facets as large as those of each film (between two bodies) are in the mean, or finer in length by a factor;
// smaller toward films of smaller ones. Sizes that the scene gives its mesh (surgery/sizing.h) stand. The
// topology of the film stays, volumes change to second order. Not for periodic films, which it leaves alone.
void make_new_mesh(scene::Scene& scene, double finer = 1);

}  // namespace lamella::evolution
