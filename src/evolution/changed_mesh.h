// What is to be put right, and compared, when the mesh of a moving film was changed.
#pragma once

#include "scene/scene.h"

namespace lamella::evolution {

// Brings vertices onto what holds them and volumes to their targets, with the pressures that go with them.
// False if that cannot be.
bool restore_volumes(scene::Scene& scene);

double potential_energy(const scene::Scene& scene);

}  // namespace lamella::evolution
