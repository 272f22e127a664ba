#include "evolution/changed_mesh.h"

#include "scene/constraint_sets.h"

namespace lamella::evolution {

std::unique_ptr<solve::Problem> restored(scene::Scene& scene) {
  scene::constrain_vertices(scene);
  auto problem = std::make_unique<solve::Problem>(scene);
  double energy = 0;
  if (problem->linearise_and_restore(scene.film.edit_positions(), energy) != solve::Ending::converged)
    return nullptr;
  problem->publish(scene);
  return problem;
}

bool restore_volumes(scene::Scene& scene) {
  return restored(scene) != nullptr;
}

double potential_energy(const scene::Scene& scene) {
  scene::Scene free = scene;
  free.keep_volumes = false;  // their gradients are not asked for
  energy::FilmEnergy terms(free);
  return terms.value(scene.film.positions());
}

}  // namespace lamella::evolution
