// The linear system of Newton's method at one shape of the film, factorised: steps and counts of modes.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "solve/basis.h"
#include "solve/hessian.h"
#include "solve/parameter_border.h"
#include "solve/problem.h"
#include "solve/sparse_factor.h"

namespace lamella::solve {

// Lives as long as the connectivity: the symbolic factorisation is made once, or taken from a memory.
class NewtonSystem {
 public:
  NewtonSystem(Problem& problem, const film::Film& film, MotionKind motion, SymbolicMemory* memory = nullptr);

  // Energy, pressures, directions and the Hessian at x. Returns the energy; false in `ok` as in
  // Problem::linearise.
  double linearise(std::span<const Vec3> x, bool& ok);
  // The same with the directions as they were, and the last factorisation, which a short step away still
  // serves: `step` mends what it lacks by iteration.
  double linearise_nearby(std::span<const Vec3> x, bool& ok);
  // Factorises with H + shift M in the place of H. False if that is singular to rounding.
  bool factorise(double shift);

  // Of the last factorisation: how many negative modes H + shift M has among the motions that keep volumes,
  // those of the film as a whole (solve/rigid_motion.h) not counted.
  int negative_modes();
  // The same with them, as plain inertia tells it; and how many modes there are at all.
  int negative_modes_with_rigid() const;
  std::size_t mode_count() const;

  // The stationary point of the quadratic model, volumes kept to first order, without motion of the film as a
  // whole; a reduced vector. Returns the slope of the energy along it (negative: downhill). Not a number
  // where the factorisation is too old to be mended.
  double step(std::span<double> reduced);
  // The part of the last step that free parameters make.
  std::span<const double> parameter_step() const { return parameter_step_; }

  // Solves with the last factorisation for right-hand sides of `unknowns + constraints` numbers each, one
  // after another, in place.
  void solve(std::span<double> values, int columns) { factor_->solve(values, columns); }

  Problem& problem() { return problem_; }
  const Basis& basis() const { return basis_; }
  ConstrainedHessian& hessian() { return hessian_; }
  const ConstrainedHessian& hessian() const { return hessian_; }
  // Minus the gradient of energy - sum pressure * volume, reduced.
  std::span<const double> force() const { return force_; }
  // 4 pi over the film's area: on a sphere its curvature squared, and the unit of what modes have.
  double scale() const { return scale_; }
  // The film's motions as a whole at the last `linearise`, orthonormal in the mass.
  const std::vector<std::vector<double>>& rigid();

 private:
  double finish_linearise(std::span<const Vec3> x, double energy);
  bool solve_refined(std::span<const double> right, std::span<double> solution);
  void border();
  double border_square(std::size_t a, std::size_t b) const;

  Problem& problem_;
  film::Film film_;  // without positions
  Basis basis_;
  ConstrainedHessian hessian_;
  std::unique_ptr<SparseFactor> factor_;
  std::vector<Vec3> x_;
  std::vector<Vec3> field_;
  std::vector<double> force_;
  double scale_ = 0;
  bool rigid_known_ = false;
  std::vector<std::vector<double>> rigid_;
  ParameterBorder parameters_;
  std::vector<double> parameter_step_;
  // Of the last factorisation A, once needed: C = (M rigid, columns of the parameters), A^-1 C, and
  // C^T A^-1 C by rows, less the derivatives by two parameters.
  bool bordered_ = false;
  std::vector<double> columns_;
  std::vector<double> solved_;
  std::vector<double> gram_;
};

}  // namespace lamella::solve
