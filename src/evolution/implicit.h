// Implicit steps of a moving film: one sparse linear system, or a few with the same factors.
#pragma once

#include <span>
#include <vector>

#include "solve/newton_system.h"

namespace lamella::evolution {

using film::Vec3;

// What a step starts from, a row a vertex or a row a volume.
struct ImplicitStart {
  std::span<const Vec3> x;
  std::span<const Vec3> v;
  std::span<const Vec3> pushes;     // accelerations by outer forces; empty for none
  std::span<const double> targets;  // volumes at the end
  double time = 0;                  // at the start
  double dt = 0;
};

// The symbolic factorisation is made once and lives as long as the connectivity.
//
// Linearly implicit Euler, after D. Baraff and A. Witkin, "Large steps in cloth simulation", SIGGRAPH 98:
// with H the Hessian of the films' Dirichlet energy at the start, which lies above that of their area,
//
//   (m/dt^2 + H) u - G^T p' = m v/dt + m f - g,   G u = V_target - V(x),   x' = x + u,   v' = u/dt.
//
// The exact Hessian is negative along the film where triangles are drawn out; with it, steps of whatever
// length gain energy without limit once that has happened.
//
// Implicit midpoint, forces of the energy and directions of the volume gradients taken at x + u/2:
//
//   m (2 u/dt^2 - 2 v/dt) = G^T p - g + m f,   V(x + u) = V_target,   v' = 2 u/dt - v,
//
// by Newton's method with the Hessian at the foreseen midpoint, renewed where changes do not shrink.
class ImplicitSolver {
 public:
  // `masses` have a row a vertex and live on. The film must be compact.
  ImplicitSolver(const scene::Scene& scene, std::span<const double> masses);

  // Each writes the moves u and the pressures. False if the system is singular or the iteration does not
  // converge; what was written is of no use then.
  bool euler(const ImplicitStart& start, std::span<Vec3> moves, std::span<double> pressures);
  bool midpoint(const ImplicitStart& start, std::span<Vec3> moves, std::span<double> pressures);

 private:
  bool linearise(std::span<const Vec3> x, double time, double shift);
  void add_inertia(const ImplicitStart& start, double per_push, double per_velocity, double per_move,
                   std::span<const Vec3> moves);
  double take_step(std::span<Vec3> moves);

  scene::Scene scene_;
  solve::Problem problem_;
  solve::NewtonSystem system_;
  std::span<const double> masses_;
  std::vector<Vec3> at_;
  std::vector<Vec3> field_;
  std::vector<double> right_;
};

}  // namespace lamella::evolution
