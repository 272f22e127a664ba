// Methods run side by side on copies of one scene, their energies recorded over processor time.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "evolution/levels.h"

namespace lamella::chart {

struct Sample {
  double seconds = 0;  // processor time since the start of the method
  std::uint32_t facets = 0;
  double energy = 0;
};

struct Curve {
  std::string method;
  std::vector<Sample> samples;
};

struct RaceOptions {
  long levels = 4;    // refinements; every method goes from coarse to fine
  double limit = 20;  // processor seconds for each method
};

// Names of the methods of this program: relax, adaptive, lbfgs, newton, cg, descent.
const std::vector<std::string>& own_methods();

// A method's curve. `relaxed`, if given, gets what the levels of `relax` tell of the limit.
Curve run_own(const std::string& method, scene::Scene scene, const RaceOptions& options,
              scene::Monitor& monitor, std::optional<evolution::Extrapolation>* relaxed = nullptr);

}  // namespace lamella::chart
