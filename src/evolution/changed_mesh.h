// What is to be put right, and compared, when the mesh of a moving film was changed.
#pragma once

#include <memory>

#include "scene/scene.h"
#include "solve/problem.h"

namespace lamella::evolution {

// Brings vertices onto what holds them and volumes to their targets, with the pressures that go with them.
// False if that cannot be.
bool restore_volumes(scene::Scene& scene);
// The same; what it was done with serves as long as the film's connectivity stays. Null if it cannot be.
std::unique_ptr<solve::Problem> restored(scene::Scene& scene);

double potential_energy(const scene::Scene& scene);

}  // namespace lamella::evolution
