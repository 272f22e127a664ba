// From any start to an equilibrium: descent, mesh upkeep, and a finish by Newton's method along normals.
#pragma once

#include <optional>

#include "scene/monitor.h"
#include "scene/scene.h"
#include "solve/lbfgs.h"
#include "solve/stability.h"

namespace lamella::evolution {

struct RelaxOptions {
  long most_iterations = 5000;
  double tolerance = 1e-10;                 // of the residual (solve/newton.h, solve/lbfgs.h)
  std::optional<solve::MotionKind> motion;  // unless given: all motions from afar, normal ones at the end
  bool upkeep = true;                       // flips and averaging while far from the end
  bool new_meshes = true;                   // where the mesh is past mending
  bool near_start = false;                  // a refined equilibrium: Newton's method at once
  bool leave_saddle = false;                // go down from a saddle, and on to a minimum
};

struct RelaxReport {
  solve::Ending ending = solve::Ending::converged;
  long iterations = 0;  // of all methods together
  long newton_steps = 0;
  long flips = 0;
  long saddles_left = 0;
  long new_meshes = 0;
  double energy = 0;
  double residual = 0;
  solve::Stability stability;  // known only where Newton's method made the end
  double smallest_angle = 0;   // radians; of facets that can move
  film::Vec3 pinch;            // where, if the film collapsed
  // Edges with more than three films, and points with more than four borders: at rest, perhaps, but no film
  // keeps them (J. Plateau; J. Taylor, Annals of Mathematics 103, 1976).
  std::size_t crowded = 0;

  bool converged() const { return ending == solve::Ending::converged; }
  bool stable() const { return converged() && stability.stable() && crowded == 0; }
};

// Relaxes the film of a scene; pressures are written to its bodies. Far from equilibrium vertices move
// freely, which reaches its neighbourhood in a few dozen iterations, and the mesh is equiangulated and
// averaged in between. Near it, free vertices would only slide along the film, toward slivers: the end is
// made by motion that changes the shape alone, first by quasi-Newton descent and then by Newton's method,
// whose last factorisation also tells whether the equilibrium is a minimum. With a tolerance so loose that
// descent meets it, or with a motion given, there is no Newton step, and stability stays unknown.
RelaxReport relax(scene::Scene& scene, const RelaxOptions& options, scene::Monitor& monitor);

// From a saddle to a place farther down, along a mode of negative curvature. False if there is none to be
// found.
bool descend_from_saddle(scene::Scene& scene, scene::Monitor& monitor);

}  // namespace lamella::evolution
