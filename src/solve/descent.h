// Descent: one step along the projected gradient, or along a direction conjugate to those before, to the
// optimum of a line search, volumes restored.
#pragma once

#include <optional>
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
// The step is that of Surface Evolver's `g`. The scale of the step before is doubled as long as the energy
// falls, or halved until it does, and the step goes to the lowest point of the parabola through the energies
// at 0, there and at twice that. At each trial volumes are brought to within 1e-4 of their targets along the
// gradients at the beginning of the step, once at least; whoever wants them exact restores them after the
// last step. When nothing lowers the energy, positions are left as they were, but for that.
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
  double move(std::span<Vec3> x, double scale) const;
  std::optional<double> search(std::span<Vec3> x, double start, double& scale, double limit) const;
  double conjugate(double squared);
  DescentStep finish(std::span<Vec3> x, double energy, double scale, double squared) const;

  Problem& problem_;
  DescentRule rule_;
  // With conjugate directions: the force here and at the step before, and its square there.
  std::vector<Vec3> force_;
  std::vector<Vec3> last_force_;
  double last_squared_ = 0;
  std::vector<Vec3> from_;
  std::vector<double> parameters_from_;
  std::vector<double> parameter_way_;
  std::vector<Vec3> direction_;
};

// The scale at which one step to try first: an explicit gradient flow of the film is stable up to about the
// inverse of its stiffest vertex.
double first_scale(const Problem& problem);

}  // namespace lamella::solve
