// One film in motion: the state between steps, and the step.
#pragma once

#include <memory>
#include <vector>

#include "energy/film_energy.h"
#include "evolution/balance.h"
#include "evolution/external_forces.h"
#include "evolution/implicit.h"
#include "evolution/paper_correction.h"
#include "evolution/step_times.h"
#include "evolution/stiff_spots.h"
#include "evolution/volume_memory.h"
#include "film/large_pages.h"
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
  implicit,  // linearly implicit Euler: stable at any step, takes energy from what swings faster
  midpoint,  // implicit midpoint: keeps energy at steps beyond the explicit bound
};

constexpr bool is_implicit(Method method) {
  return method == Method::implicit || method == Method::midpoint;
}

// How volumes are kept in a step.
enum class VolumeMode {
  automatic,  // lagged as long as that misses no volume by much; what it misses is made good in what is shown
  lagged,     // in one pass: what the step leaves is foreseen, and what that misses goes into the next step
  exact,      // repeated along the gradients at the start of the step until volumes are right to 1e-12
  paper,      // once, along averaged normals at the end of the step (evolution/paper_correction.h)
};

// The motion of one scene on one connectivity. Positions and velocities are double-buffered, so that undoing
// a step that fails is a matter of not taking it over.
//
// A step of symplectic Euler, with gradients g of the energy and G of the volumes taken at its start, masses
// m, pressures p, accelerations f by outer forces:
//
//   v' = exp(-damping dt) (v + dt f - dt/m (g - p G))     with the pressures of the step before,
//   v' += 1/m G^T lambda,  p += lambda/dt                 (G 1/m G^T) lambda = (V_target - V - q)/dt - G v',
//   x' = x + dt v'
//
// where q is what the last steps had beyond first order (evolution/volume_memory.h). One sweep gives g, G,
// volumes and the stability bound. What x' misses of the volumes, some 1e-7 of them, goes into the next step;
// whoever looks at the film is shown it *settled*: put along G until its volumes are right, as the next step
// will do. Where volumes are wanted exact, those at x' are measured and the same G and factors serve to
// correct x' and v', until they are right.
//
// Verlet makes the first half of the kick before, the second after the move, there with velocities projected
// so that they keep the volumes (H. C. Andersen, "Rattle: a velocity version of the Shake algorithm", Journal
// of Computational Physics 52, 1983). The gradient flow moves by dt/m (p G - g) + dt f. The implicit methods
// are in evolution/implicit.h; what they leave of the volumes is corrected in the same way.
class Motion {
 public:
  explicit Motion(scene::Scene& scene, Method method = Method::euler,
                  VolumeMode volumes = VolumeMode::automatic);
  ~Motion();

  // The largest stable step at the present shape: 2/sqrt(max s_v/m_v) over the vertices that move, without
  // the root for the gradient flow; where few vertices are the stiffest, their neighbours take some of it
  // over (evolution/stiff_spots.h).
  double bound() const { return bound_; }
  // The bound by the stiffest vertex alone, without units: over the time that a film as massive and as finely
  // divided takes to swing. About 1.2 for equilateral triangles at tension 1, small where slivers choke the
  // steps; refinement leaves it.
  double fitness() const;
  // The stiffness over mass of a vertex that would give the mesh this fitness.
  double stiffness_at(double fitness) const;
  // Moves by dt, which should lie below the bound; the scene's time and pressures follow. Anything but
  // Ending::step_limit means that nothing has changed: the result would not be finite, its volumes could not
  // be kept, or its energy would have risen from nowhere.
  solve::Ending step(double dt);
  // The largest step that the method survives by linear theory: the bound, or any.
  double largest_step() const { return is_implicit(method_) ? HUGE_VAL : bound_; }
  // From the next step on each of these sets of vertices moves as one body; what velocities differ from the
  // set's mean is lost. What is missing of volumes is made good by the others, nearly alone.
  void hold_together(std::vector<std::vector<film::Vertex>> sets);
  // Whether a step can be made from here: numbers are finite, and the volumes can be kept.
  bool is_sound() const { return sound_; }
  // Copies settled positions, velocities and masses to the scene.
  void store();
  // The same at the end of a motion that another one may take up.
  void leave();

  std::span<const Vec3> positions() const { return x_; }  // not settled
  std::span<const Vec3> speeds() const { return v_; }
  // The farthest that a vertex went in the last step that was made.
  double last_move() const;
  double energy() const { return energy_; }
  double kinetic() const { return kinetic_; }
  // The largest of a volume of the settled film, in parts of it.
  double volume_error();
  const StepTimes& times() const { return times_; }
  Balance balance() const { return evolution::balance(x_, v_, masses_); }

 private:
  using Vectors = std::vector<Vec3, film::LargePages<Vec3>>;

  class SweepWork;
  bool linearise();
  energy::VolumeGradient::Fields fields_at(std::size_t row, std::span<const Vec3> velocities) const;
  double stiffness_over_mass(std::size_t row) const;
  void push();
  bool multiply();
  bool conclude();
  double bound_by(double rate) const;
  double closer_rate();
  double sweep_next(bool kicks);
  bool goes_with_sweep() const;
  void weigh();
  bool propose();
  // How a step changes velocities: kept * (carried * v + push * acceleration).
  struct Pace {
    double dt = 0;
    double carried = 0;
    double push = 0;
    double span = 0;  // the time for which outer forces act
    double kept = 1;  // by damping
  };
  Pace pace(double dt) const;
  // Sums over vertices of the work of outer forces and of energies of motion (twice, by axes): after the
  // kick, and at the end.
  struct KickSums {
    double work = 0;
    energy::Lane kicked{};
    energy::Lane kinetic{};
    KickSums& operator+=(const KickSums& other) {
      work += other.work;
      kicked += other.kicked;
      kinetic += other.kinetic;
      return *this;
    }
  };
  void prepare_kick();
  void kick(const Pace& pace, bool drifts);
  void kick_rows(const Pace& pace, bool drifts, std::size_t first, std::size_t last, KickSums& sums);
  void take_over(const KickSums& sums);
  // Whether volumes play no part in forces.
  bool is_free() const { return errors_.empty() || paper_ != nullptr; }
  // The implicit methods move all vertices alike.
  bool holds() const { return !held_.empty() && !is_implicit(method_); }
  void drift(double dt);
  void stiffen();
  // Whether all vertices move.
  bool is_loose() const;
  void give_back_momentum(double dt);
  void shed_excess(double dt);
  bool second_kick(double dt);
  bool settle_velocities(double dt);
  bool implicit_step(double dt);
  bool keep_constraints(double dt);
  solve::Ending undo(solve::Ending why);
  bool rises_from_nowhere(double energy, double kinetic) const;
  void accept(double dt, double energy);

  // In motion_volumes.cpp.
  bool settles() const;
  const Vectors& settled();
  Vectors velocities_when_settled();
  void take_up_swept_places();
  double target(std::size_t row, double time) const;
  double smallest_target() const;
  void foresee_volumes(const Pace& pace);
  void impose_volumes(double dt);
  void project_velocities(double dt);
  void correct(double dt);
  bool goes_in_one_pass() const;
  bool keep_volumes(double dt);
  double most_missed() const;
  double compare(std::span<const double> volumes, double time);
  double look_at_volumes(std::span<const Vec3> positions, double time);
  bool correct_as_paper(double dt);
  bool missed_too_far(double dt) const;
  void remember_volumes(double dt);
  double pressure_span(double dt) const;

  scene::Scene& scene_;
  Method method_;
  VolumeMode volume_mode_;
  energy::FilmEnergy terms_;
  ExternalForces forces_;
  solve::GramSolver gram_;
  VolumeMemory memory_;
  std::unique_ptr<PaperCorrection> paper_;
  std::unique_ptr<ImplicitSolver> implicit_;
  energy::VolumeGradient::Products products_;  // of the gradients with v_ and with what accelerates it at x_
  std::unique_ptr<SweepWork> work_;
  std::vector<double> masses_;
  std::vector<double> ones_;     // where volumes are kept of sets that are held
  std::vector<double> weights_;  // inverse masses, 0 for vertices that stay
  std::vector<double> answers_;  // the same to volumes that are to be made good
  Vectors x_;
  Vectors v_;
  Vectors next_x_;
  Vectors next_v_;
  Vectors settled_;  // empty until someone looks
  double settled_error_ = 0;
  bool is_settled_ = false;
  std::vector<std::vector<film::Vertex>> held_;
  Balance kicked_;  // where sets are held: after the kick, its momenta to be had at the end of the step
  std::vector<Vec3> pushes_;  // accelerations by outer forces; empty without them
  std::vector<double> errors_;
  std::vector<double> multipliers_;
  std::vector<double> present_;   // volumes at x_
  std::vector<double> foreseen_;  // volumes that the step being made would have to first order
  std::vector<double> reached_;   // and those it had, before what was left was corrected
  std::vector<double> pressures_;
  std::vector<double> next_pressures_;
  double energy_ = 0;
  double kinetic_ = 0;
  double next_kinetic_ = 0;
  double pushed_ = 0;  // work of outer forces in the step being made
  double damped_ = 0;  // energy that damping takes in it
  double bound_ = 0;
  StiffSpots stiff_spots_;
  std::vector<film::Vertex> spots_;
  std::vector<Vec3> images_;  // where a film is periodic: positions with those of images
  double mass_ = 0;
  Pace pace_;                     // of the step being made
  bool kicks_in_sweep_ = false;   // its kick has not been made yet
  bool multiplied_ = false;       // the sweep at its end has given the products
  bool one_pass_ = false;         // it does not look at its volumes
  bool relies_on_sweep_ = false;  // or not after the last correction
  bool distrusts_rate_ = false;   // that has failed: the step is being made again
  StepTimes times_;
  Stopwatch watch_;
  bool sound_ = false;
  bool pushed_soundly_ = true;  // outer forces are finite
};

}  // namespace lamella::evolution
