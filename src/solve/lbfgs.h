// Quasi-Newton descent in the metric of the film's Laplacian: the workhorse of `relax`.
#pragma once

#include "scene/monitor.h"
#include "solve/freedom.h"
#include "solve/problem.h"

namespace lamella::solve {

struct LbfgsOptions {
  long most_iterations = 2000;
  // Ends when the estimated excess of the energy over the minimum, relative to the energy, falls below this.
  double tolerance = 1e-10;
  MotionKind motion = MotionKind::normal;
};

struct LbfgsReport {
  Ending ending = Ending::converged;
  long iterations = 0;
  double energy = 0;
  // Half of minus the slope along the last quasi-Newton direction, over the energy: the relative excess a
  // quadratic model sees. Dimensionless, and independent of the mesh.
  double residual = 0;
};

// Limited-memory BFGS (memory 10; J. Nocedal, S. Wright, "Numerical Optimization", chapter 7) whose initial
// metric is the factorised Laplacian, renewed every 20 iterations, projected on the directions that keep
// volumes to first order. Each trial is brought back to its volumes before its energy is judged (Armijo's
// rule, backtracking by a parabola). If no step lowers the energy the memory is dropped and the Laplacian
// renewed; if that does not help either it ends.
LbfgsReport lbfgs(Problem& problem, const scene::Scene& scene, std::span<Vec3> x, const LbfgsOptions& options,
                  scene::Monitor& monitor);

}  // namespace lamella::solve
