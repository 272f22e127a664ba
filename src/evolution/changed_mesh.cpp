#include "evolution/changed_mesh.h"

#include "energy/film_energy.h"
#include "scene/constraint_sets.h"
#include "solve/problem.h"

namespace lamella::evolution {

bool restore_volumes(scene::Scene& scene) {
  scene::constrain_vertices(scene);
  solve::Problem problem(scene);
  double energy = 0;
  if (problem.linearise_and_restore(scene.film.edit_positions(), energy) != solve::Ending::converged)
    return false;
  problem.publish(scene);
  return true;
}

double potential_energy(const scene::Scene& scene) {
  energy::FilmEnergy terms(scene);
  return terms.value(scene.film.positions());
}

}  // namespace lamella::evolution
