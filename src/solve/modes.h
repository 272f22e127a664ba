// The softest modes of a film at its present shape: eigenvectors of the Hessian under the volume constraints.
#pragma once

#include <vector>

#include "scene/monitor.h"
#include "solve/newton_system.h"

namespace lamella::solve {

// H x = value M x on the motions that keep volumes to first order, M being the lumped mass of a film of unit
// density: the square of the frequency at which such a film would swing, negative where it falls.
struct Mode {
  double value = 0;
  double rigid_part = 0;        // how much of it (squared) is motion of the film as a whole: 0 to 1
  std::vector<double> reduced;  // x^T M x = 1
};

// The `count` lowest modes at the system's last `linearise`, the lowest first; fewer if the film has fewer.
// Block Lanczos with the shifted inverse (R. Grimes, J. Lewis, H. Simon, SIAM J. Matrix Anal. Appl. 15,
// 1994), every vector kept orthogonal to all others: a few solves a mode. Values to about ten digits.
// Empty if the Hessian cannot be factorised or the monitor asked to stop.
std::vector<Mode> lowest_modes(NewtonSystem& system, int count, scene::Monitor& monitor);

}  // namespace lamella::solve
