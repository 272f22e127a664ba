// Minimise the energy of a scene's film while the volumes of its bodies keep their targets and fixed vertices
// stay.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "energy/film_energy.h"
#include "scene/scene.h"
#include "solve/free_parameters.h"
#include "solve/gram_solver.h"

namespace lamella::solve {

using film::Vec3;

// How a computation ended. Everything but the first three is a failure the caller reports.
enum class Ending {
  converged,
  step_limit,       // as many steps as were asked for
  stopped,          // by Ctrl-C
  stuck,            // no step along the gradient lowers the energy, though the residual is not small
  not_finite,       // energy or gradient is not a number
  volume_lost,      // the volumes could not be brought to their targets
  collapsed,        // facets shrink to nothing, as where a neck pinches
  constraint_lost,  // vertices could not be put onto their constraints
  tangled,          // films would pass through one another, however small the steps
};

std::string_view describe(Ending ending);

// How volumes are brought back: with new gradients where the old ones lead there too slowly, or giving up
// then.
enum class RestoreMode { renew_gradients, same_gradients };

// Energy, constraints and the state of one film. Positions belong to the caller (the film's own rows, edited
// in place); weights are the inverse masses with which vertices answer a force: 0 for a fixed one.
class Problem {
 public:
  explicit Problem(const scene::Scene& scene);

  std::size_t vertex_count() const { return energy_.vertex_count(); }
  energy::FilmEnergy& energy() { return energy_; }
  const energy::FilmEnergy& energy() const { return energy_; }
  bool movable(std::size_t vertex) const { return weights_[vertex] != 0; }
  std::span<const double> weights() const { return weights_; }
  std::size_t constraint_count() const { return targets_.size(); }
  std::span<const double> targets() const { return targets_; }
  void set_targets(const scene::Scene& scene);

  // Evaluates energy, gradient and volume gradients at x, and the multipliers (pressures) that leave the
  // smallest projected gradient. Returns the energy. False in `ok` if a number is not finite or the
  // constraints are degenerate.
  double linearise(std::span<const Vec3> x, bool& ok);
  // After `linearise`: minus the gradient of energy - sum pressure * volume, zero at fixed vertices.
  // `direction` has a row a vertex. Returns its squared length.
  double descent_direction(std::span<Vec3> direction);
  std::span<const double> pressures() const { return pressures_; }
  // After `descent_direction`: what it is for the free parameters, each times its scale.
  std::span<const double> parameter_direction() const { return parameter_direction_; }
  // After `descent_direction`: the whole force at a vertex, with what its constraints and weight would take
  // out.
  Vec3 force(std::size_t vertex) const;
  // Minus the gradient at other positions with the pressures as they are, within the constraints there (and
  // where fixed vertices are, 0). False where it is not finite.
  bool force_at(std::span<const Vec3> x, std::span<Vec3> field);
  // Takes out of a field what changes volumes to first order, and what would move fixed vertices.
  void project(std::span<Vec3> field);

  // Puts x onto the constraints of its vertices. False where that fails.
  bool constrain(std::span<Vec3> x);

  // The scene's parameters that are unknowns too; moving them moves the levels and boundaries that vertices
  // are to be put onto.
  FreeParameters& parameters() { return parameters_; }
  const FreeParameters& parameters() const { return parameters_; }
  void set_parameters(std::span<const double> values) { parameters_.set(energy_, values); }
  void set_parameters(std::span<const double> from, double times, std::span<const double> way) {
    parameters_.set(energy_, from, times, way);
  }
  // They stay as they are from now on.
  void hold_parameters() { parameters_ = {}; }

  // energy - sum pressures * (volume - target), with the pressures of the last `linearise`.
  double merit(std::span<const Vec3> x);

  // The largest relative error of a volume at the last evaluation.
  double volume_error() const;
  // Moves x along the volume gradients until every volume has its target to rounding (about 1e-13 relative);
  // the gradients of the last `linearise` serve as long as they lead there fast, then it linearises anew. One
  // pass at most changes a volume by a fifth to a quarter, so that large changes do not tangle. On return
  // `energy` is the energy at x. Ending::converged or volume_lost or not_finite.
  Ending restore_volumes(std::span<Vec3> x, double& energy, RestoreMode mode = RestoreMode::renew_gradients);

  // The same from positions that nothing has been evaluated at: linearises there first. Leaves `energy` as it
  // is where that fails.
  Ending linearise_and_restore(std::span<Vec3> x, double& energy);

  // The same with the gradients of the last `linearise` alone, until volumes are within `tolerance` of their
  // targets (relative to 1 or to them, whichever is more), but not often: enough to compare energies. Returns
  // the energy, infinite where constraints are lost.
  double restore_roughly(std::span<Vec3> x, double tolerance);
  // From where `linearise` has just found this energy.
  double restore_roughly(std::span<Vec3> x, double tolerance, double energy);

  // Writes pressures to the scene's bodies, and the parameters of vertices on boundaries.
  void publish(scene::Scene& scene) const;

 private:
  bool factorise();
  bool factorise_parameters();
  bool find_pressures();
  void let_go(std::span<const Vec3> x);
  void solve_gram(std::span<const double> right, std::span<double> result) const;
  void move_parameters();
  void volume_errors(std::span<double> errors) const;
  void limit(std::span<double> errors) const;
  bool make_good(std::span<Vec3> x, std::span<const double> errors);

  energy::FilmEnergy energy_;
  FreeParameters parameters_;
  std::vector<double> weights_;
  std::vector<double> targets_;
  std::vector<double> volume_scale_;  // for relative errors
  double volume_tolerance_ = 0;       // relative
  GramSolver gram_;
  energy::VolumeGradient::Products products_;  // of the gradients of what is held with that of the energy
  // What free parameters add to the Gram matrix, G + A S A^T: the columns G^-1 A, and the inverse of
  // S^-1 + A^T G^-1 A (M. Woodbury, 1950).
  std::vector<double> solved_slopes_;
  std::vector<double> small_inverse_;
  std::vector<double> parameter_direction_;
  std::vector<double> pressures_;
  std::vector<double> errors_;
  std::vector<double> multipliers_;
  std::vector<Vec3> force_;  // only where one-sided constraints hold some vertex
};

}  // namespace lamella::solve
