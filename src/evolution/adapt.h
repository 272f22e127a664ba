// Refinement where it lowers the error.
#pragma once

#include <cstdint>

#include "scene/scene.h"

namespace lamella::evolution {

// An estimate of what each facet adds to the error of the energy, from the angles between neighbouring
// facets: a film of curvature k on facets of size h has k^2 h^2 / 24 too much or too little of its area, and
// turns by k h from facet to facet. On a rim that follows a curve, what lies between the chord and the curve
// is added. One number a row of facets.
std::vector<double> facet_errors(const scene::Scene& scene);

// Halves every edge; new vertices on a curve are put on it.
void refine_everywhere(scene::Scene& scene);

// Halves the edges of the facets with the largest errors, and those of neighbours where that keeps the facets
// well shaped. Errors of halved facets fall sixteenfold, so all are taken that are not yet that much better
// than the worst: where the error is even, that is all of them. New vertices on a curve are put on it.
// Returns how many facets came to be.
std::uint32_t refine_where_needed(scene::Scene& scene);

}  // namespace lamella::evolution
