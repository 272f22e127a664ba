// Newton's method on the constrained problem: the finisher, quadratic near an equilibrium and safe elsewhere.
#pragma once

#include "scene/monitor.h"
#include "solve/newton_system.h"
#include "solve/stability.h"

namespace lamella::solve {

// What to do where the energy has directions of negative curvature (motions as a whole not counted).
enum class SaddlePolicy : std::uint8_t {
  shift,  // add to the Hessian until there is none, so that every step goes downhill
  keep,   // go to the stationary point all the same, uphill too, as far as the quadratic model holds
};

struct NewtonStep {
  Ending ending = Ending::step_limit;  // step_limit means: the step was made
  double energy = 0;                   // after the step
  double area = 0;
  // Before the step: half of minus the slope along Newton's direction over the energy, which is the relative
  // excess that the quadratic model sees. Negative towards a maximum.
  double residual = 0;
  double fraction = 0;     // of the step that was made: 1 for all of it
  int negative_modes = 0;  // of the Hessian as it is
  double shift = 0;        // that was added to it (times mass)
};

// Makes one step after another with the same symbolic factorisation.
class Newton {
 public:
  Newton(Problem& problem, const film::Film& film, MotionKind motion, SymbolicMemory* memory = nullptr);

  // One step, shortened until the energy at restored volumes does not rise (towards a saddle that is to be
  // kept: until it changes as the model says, to a half); where nothing helps, positions stay as they were
  // and the ending is `stuck`. Volumes must be right before it.
  NewtonStep step(std::span<Vec3> x, SaddlePolicy policy);
  // A step with the factorisation of the last one, where that still serves: else nothing moves, and the
  // ending is `stuck`. The residual must have fallen by more than a little, to be worth it.
  NewtonStep step_again(std::span<Vec3> x);
  // To the lowest energy along the direction (both ways), up to `longest` times the full step.
  NewtonStep seek(std::span<Vec3> x, double longest);
  // The residual at x, and negative modes; nothing moves.
  NewtonStep look(std::span<const Vec3> x);

  NewtonSystem& system() { return system_; }

 private:
  void remember(std::span<const Vec3> x);
  bool find_direction(std::span<const Vec3> x, SaddlePolicy policy, NewtonStep& result);
  bool shift_until_definite(NewtonStep& result);
  bool search(std::span<Vec3> x, bool uphill, NewtonStep& result);
  bool try_fraction(std::span<Vec3> x, double fraction, double& energy);
  void finish(std::span<Vec3> x, NewtonStep& result);

  Problem& problem_;
  NewtonSystem system_;
  std::vector<double> reduced_;
  std::vector<Vec3> from_;
  std::vector<double> parameters_from_;
  std::vector<Vec3> direction_;
  double slope_ = 0;
  double last_shift_ = 0;
  double last_residual_ = 0;
};

struct NewtonOptions {
  long most_steps = 50;
  double tolerance = 1e-10;  // of the residual
  MotionKind motion = MotionKind::normal;
  SaddlePolicy saddle = SaddlePolicy::shift;
};

struct NewtonReport {
  Ending ending = Ending::converged;
  long steps = 0;
  double energy = 0;
  double residual = 0;
  Stability stability;  // known if converged: by the factorisation of the last step
};

// Steps until the residual is below the tolerance and the last step has been made. Where that ends at a
// saddle in spite of SaddlePolicy::shift, because no force points away from it, the last steps keep it.
NewtonReport newton(Newton& method, std::span<Vec3> x, const NewtonOptions& options, scene::Monitor& monitor);

}  // namespace lamella::solve
