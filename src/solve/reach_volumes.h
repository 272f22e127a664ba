// Brings bodies to volumes far from those they have, films and mesh kept whole.
#pragma once

#include <span>

#include "scene/scene.h"
#include "solve/problem.h"

namespace lamella::solve {

// Moves x until every volume has its target to rounding, as Problem::restore_volumes does, which moves each
// vertex by the volume gradient it stands on: right for small errors, but a large change would fold the film
// at a border, beyond which the next film does not move at all. So large errors are first made small in steps
// of at most a fifth of a volume along fields that stretch films evenly: of all fields with the wanted change
// of volumes, those of the least Dirichlet energy. Returns as Problem::restore_volumes; x is to be thrown
// away where that is not Ending::converged.
Ending reach_volumes(const scene::Scene& scene, Problem& problem, std::span<Vec3> x, double& energy);

}  // namespace lamella::solve
