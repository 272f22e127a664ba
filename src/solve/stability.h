// Whether an equilibrium is a minimum, by the inertia of its Hessian.
#pragma once

#include "solve/newton_system.h"

namespace lamella::solve {

struct Stability {
  bool known = false;      // false where the Hessian is singular to rounding
  int negative_modes = 0;  // motions that keep volumes to first order and lower the energy to second
  int neutral_modes = 0;   // slightly negative ones, which may as well be none

  bool stable() const { return known && negative_modes == 0; }
};

// At the shape of the system's last `linearise`, which must be an equilibrium to mean anything. Motions of
// the film as a whole are not counted (solve/rigid_motion.h), and modes between 0 and minus a thousandth of
// NewtonSystem::scale are neutral: other symmetries of a film, which a mesh blurs. Costs one factorisation
// for a minimum, two for a saddle.
Stability stability(NewtonSystem& system);

}  // namespace lamella::solve
