// A few facets tried out before they are made: some corners free to move, the others held.
#pragma once

#include <array>
#include <vector>

#include "film/vec3.h"

namespace lamella::surgery {

struct TrialFacet {
  std::array<int, 3> corners{};  // indices of points
  double tension = 1;
  double pressure = 0;  // behind, less that in front
};

struct TrialFilm {
  std::vector<film::Vec3> points;  // those that are free come first
  int free = 0;
  std::vector<TrialFacet> facets;
};

// Tension times area, less pressure times volume (up to a constant that depends on the held points alone).
double energy(const TrialFilm& film);

// Moves the free points downhill, never farther than `radius` from `centre`, by so many gradient steps at the
// most; each lowers the energy. Returns the energy.
double relax(TrialFilm& film, const film::Vec3& centre, double radius, int most_steps = 60);

// The smallest altitude of a facet.
double smallest_altitude(const TrialFilm& film);

}  // namespace lamella::surgery
