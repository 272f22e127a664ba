// Down from a saddle.
#pragma once

#include "scene/monitor.h"
#include "solve/newton_system.h"

namespace lamella::solve {

struct Departure {
  bool known = false;  // false where the modes could not be found
  double value = 0;    // of the lowest mode that is not a motion of the film as a whole
  bool moved = false;
  double energy = 0;
  double scale = 0;  // along the mode, whose mass is 1
};

// Moves x along the lowest mode to about the lowest energy on that line, at most `longest` far; nowhere if
// that mode does not lower the energy. x as at the system's last `linearise`.
Departure leave_saddle(NewtonSystem& system, std::span<Vec3> x, double longest, scene::Monitor& monitor);

}  // namespace lamella::solve
