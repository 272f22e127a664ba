// From any start to an equilibrium: descent, mesh upkeep, and a finish along normals.
#pragma once

#include <optional>

#include "scene/monitor.h"
#include "scene/scene.h"
#include "solve/lbfgs.h"

namespace lamella::evolution {

struct RelaxOptions {
  long most_iterations = 5000;
  double tolerance = 1e-10;                 // of the residual (solve/lbfgs.h)
  std::optional<solve::MotionKind> motion;  // unless given: all motions from afar, normal ones at the end
  bool upkeep = true;                       // flips and averaging while far from the end
};

struct RelaxReport {
  solve::Ending ending = solve::Ending::converged;
  long iterations = 0;
  long flips = 0;
  double energy = 0;
  double residual = 0;
};

// Relaxes the film of a scene; pressures are written to its bodies. Far from equilibrium vertices move
// freely, which reaches its neighbourhood in a few dozen iterations, and the mesh is equiangulated and
// averaged in between. Near it, free vertices would only slide along the film, toward slivers: the end is
// made by motion that changes the shape alone.
RelaxReport relax(scene::Scene& scene, const RelaxOptions& options, scene::Monitor& monitor);

}  // namespace lamella::evolution
