// Descent: one step along the projected gradient, or along a direction conjugate to those before, to the
// optimum of a line search, volumes restored.
#pragma once

#include <vector>

#include "scene/monitor.h"
#include "solve/problem.h"

namespace lamella::solve {

struct DescentStep {
  Ending ending = Ending::step_limit;  // step_limit means: the step was made
  double energy = 0;                   // after the step
  double area = 0;
  double scale = 0;           // how far along minus the gradient
  double predicted_gain = 0;  // half the scale times the squared gradient: what a parabola promises
};

// Makes one descent step after another with the same work arrays.
//
// The line search looks at the merit function energy - sum pressure * (volume - target) along the line: its
// slope at 0 is known, so one trial at the last scale gives a parabola and its minimum the step. The step is
// taken if the merit then lies below its value at 0, else it is shortened. When nothing lowers the merit,
// positions are left as they were.
//
// Conjugate directions (E. Polak and G. Ribiere's, which begin anew by themselves where they lose their
// worth) bend each force by the last direction; Evolver's `U`.
enum class DescentRule : std::uint8_t { steepest, conjugate };

class Descent {
 public:
  explicit Descent(Problem& problem, DescentRule rule = DescentRule::steepest);

  // `scale` is the first guess, and on return the scale used; with `fixed` it is used as it is, whatever the
  // energy does (only a result that is not finite is undone). Scales stay below `limit`.
  DescentStep step(std::span<Vec3> x, double& scale, bool fixed, double limit);

 private:
  void place(std::span<Vec3> x, double scale) const;
  bool search(std::span<Vec3> x, double start, double squared, double& scale, double limit);
  double conjugate(double squared);
  DescentStep finish(std::span<Vec3> x, double scale, double squared, double start);

  Problem& problem_;
  DescentRule rule_;
  // With conjugate directions: the force here and at the step before, and its square there.
  std::vector<Vec3> force_;
  std::vector<Vec3> last_force_;
  double last_squared_ = 0;
  std::vector<Vec3> from_;
  std::vector<Vec3> direction_;
};

// The scale at which one step to try first: an explicit gradient flow of the film is stable up to about the
// inverse of its stiffest vertex.
double first_scale(const Problem& problem);

}  // namespace lamella::solve
