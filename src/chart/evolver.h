// Surface Evolver as a method among others, where it is installed.
#pragma once

#include "chart/race.h"

namespace lamella::chart {

// Names of its modes: evolver_g, evolver_U, evolver_hessian.
const std::vector<std::string>& evolver_modes();

bool evolver_installed();

// Runs a mode on the scene, written as a datafile to a folder of its own. From coarse to fine like the
// others: descent goes on at each level while ten steps gain more than a 1e-8th; the third mode follows the
// recipe of its manual (a few steps, equiangulation and averaging, then hessian). Times are those that it
// tells itself, loading not counted.
Curve run_evolver(const std::string& mode, const scene::Scene& scene, const RaceOptions& options);

}  // namespace lamella::chart
