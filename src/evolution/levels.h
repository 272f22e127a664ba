// Relaxation from coarse to fine, and to a wanted accuracy.
#pragma once

#include <optional>
#include <vector>

#include "evolution/relax.h"

namespace lamella::evolution {

// A relaxed film at one resolution.
struct Level {
  std::uint32_t facets = 0;
  double energy = 0;
};

// What a sequence of levels tells of the limit of ever finer meshes. Errors of linear facets are proportional
// to 1/facets; where the last three levels fall more slowly, as they do.
struct Extrapolation {
  double energy = 0;    // the limit
  double estimate = 0;  // of the last level's relative error
  double order = 0;     // the energy's error falls as facets^-order, by the last three levels; 0 if unknown
};
std::optional<Extrapolation> extrapolate(const std::vector<Level>& levels);

struct LevelsReport {
  RelaxReport relax;          // of the last level
  std::vector<Level> levels;  // with the one at the start
  std::optional<Extrapolation> extrapolation;
  bool accurate = false;  // whether the wanted accuracy was reached
};

// Relaxes, and then refines every facet and relaxes, so many times. Only the last level is brought to the
// tolerance and looked at for stability.
LevelsReport relax_levels(scene::Scene& scene, long levels, const RelaxOptions& options,
                          scene::Monitor& monitor);

// Refines where it is needed and relaxes until the estimated relative error of the energy is below
// `accuracy`, or the next level would have more than `most_facets`.
LevelsReport relax_to(scene::Scene& scene, double accuracy, double most_facets, const RelaxOptions& options,
                      scene::Monitor& monitor);

}  // namespace lamella::evolution
