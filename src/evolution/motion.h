// One film in motion: the state between steps, and the step.
#pragma once

#include <vector>

#include "energy/film_energy.h"
#include "evolution/balance.h"
#include "evolution/external_forces.h"
#include "scene/scene.h"
#include "solve/gram_solver.h"
#include "solve/problem.h"

namespace lamella::evolution {

using film::Vec3;

// How a step is made.
enum class Method {
  euler,     // symplectic Euler, as in the paper
  verlet,    // velocity Verlet with constraints (RATTLE): the same path, velocities at whole steps
  gradient,  // parabolic: mean curvature flow, velocities play no part
};

// The motion of one scene on one connectivity. Positions and velocities are double-buffered, so that undoing
// a step that fails is a matter of not taking it over.
//
// A step of symplectic Euler, with gradients g of the energy and G of the volumes taken at its start, masses
// m, pressures p, accelerations f by outer forces:
//
//   v' = exp(-damping dt) (v + dt f - dt/m (g - p G))        the pressures of the step before serve as a
//   guess x' = x + dt v' until the volumes at x' are right:  lambda from (G 1/m G^T) lambda = V_target -
//   V(x'),
//       x' += 1/m G^T lambda,   v' += 1/(m dt) G^T lambda,   p += lambda/dt^2
//
// One sweep for g, G, volumes and the stability bound, and mostly one more for the volumes at x'. Verlet
// makes the first half of the kick before, the second after the move, there with velocities projected so that
// they keep the volumes (H. C. Andersen, "Rattle: a velocity version of the Shake algorithm", Journal of
// Computational Physics 52, 1983). The gradient flow moves by dt/m (p G - g) + dt f.
class Motion {
 public:
  explicit Motion(scene::Scene& scene, Method method = Method::euler);

  // The largest stable step at the present shape: 2/sqrt(max s_v/m_v) over the vertices that move, without
  // the root for the gradient flow.
  double bound() const { return bound_; }
  // The bound without units: over the time that a film as massive and as finely divided takes to swing. About
  // 1.2 for equilateral triangles at tension 1, small where slivers choke the steps; refinement leaves it.
  double fitness() const;
  // Moves by dt, which should lie below the bound; the scene's time and pressures follow. Anything but
  // Ending::step_limit means that nothing has changed: the result would not be finite, its volumes could not
  // be kept, or its energy would have risen from nowhere.
  solve::Ending step(double dt);
  // Copies positions, velocities and masses to the scene.
  void store();

  double energy() const { return energy_; }
  double kinetic() const { return kinetic_; }
  double volume_error() const;
  Balance balance() const { return evolution::balance(x_, v_, masses_); }

 private:
  bool linearise();
  void weigh();
  void kick_and_drift(double kick, double drift);
  void descend(double dt);
  bool second_kick(double dt);
  void project_velocities(double dt);
  void correct(double dt);
  bool keep_constraints(double dt);
  solve::Ending undo(solve::Ending why);
  bool keep_volumes(double dt);
  bool rises_from_nowhere(double energy, double kinetic) const;

  scene::Scene& scene_;
  Method method_;
  energy::FilmEnergy terms_;
  ExternalForces forces_;
  solve::GramSolver gram_;
  std::vector<double> gram_values_;
  std::vector<double> masses_;
  std::vector<double> ones_;
  std::vector<double> weights_;  // inverse masses, 0 for vertices that stay
  std::vector<Vec3> x_;
  std::vector<Vec3> v_;
  std::vector<Vec3> next_x_;
  std::vector<Vec3> next_v_;
  std::vector<Vec3> pushes_;  // accelerations by outer forces; empty without them
  std::vector<double> errors_;
  std::vector<double> multipliers_;
  std::vector<double> pressures_;
  std::vector<double> next_pressures_;
  double energy_ = 0;
  double kinetic_ = 0;
  double next_kinetic_ = 0;
  double work_ = 0;    // of outer forces in the step being made
  double damped_ = 0;  // energy that damping takes in it
  double bound_ = 0;
  double mass_ = 0;
  double pass_rate_ = 1;  // how much of a volume error a correction leaves
  bool sound_ = false;
  bool pushed_soundly_ = true;  // outer forces are finite
};

}  // namespace lamella::evolution
