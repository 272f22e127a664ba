// Refinement where it lowers the error.
#pragma once

#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "scene/scene.h"

namespace lamella::evolution {

// An estimate of what a facet adds to the energy's error. Inside the film by the angles to its neighbours: a
// film of curvature k on facets of size h has k^2 h^2 / 24 too much of its area, and turns by k h from facet
// to facet. At a rim that follows a curve, what lies between the chord and the curve, negative where the
// chord cuts off film.
struct FacetError {
  double inside = 0;
  double rim = 0;
  double size() const { return inside + std::abs(rim); }
};

// One a row of facets.
std::vector<FacetError> facet_errors(const scene::Scene& scene);

struct ErrorSums {
  double whole =
      0;  // what the energy of this mesh has too much: near the truth at an equilibrium that it resolves
  double sizes = 0;  // without that errors cancel
};
ErrorSums sum_errors(std::span<const FacetError> errors);

// Halves every edge; new vertices on a curve are put on it.
void refine_everywhere(scene::Scene& scene);

// The same for a film near its equilibrium: new vertices go where the smooth film is that the facets stand
// for (evolution/bulge.h), which leaves Newton's method a step or two less.
void refine_smoothly(scene::Scene& scene);

// Halves the edges of the facets with the largest errors, and those of neighbours where that keeps the facets
// well shaped: all that are not yet several times better than the worst. Where that promises less than to
// halve all, which is so where rims and curvature make up for each other, it halves all. New vertices on a
// curve are put on it. Returns how many facets came to be.
std::uint32_t refine_where_needed(scene::Scene& scene);

}  // namespace lamella::evolution
