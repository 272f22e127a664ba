// Volumes of regions in a periodic film.
#pragma once

#include <span>
#include <vector>

#include "film/unfolding.h"
#include "scene/scene.h"

namespace lamella::energy {

// What a film gives as the volume of a region is known up to multiples of the cell's. The multiples to be
// added, by region: those that bring the volume nearest to the target, or, where there is none, between
// nothing and a whole cell. `volumes` are the film's, without volconst.
std::vector<double> whole_cells(const scene::Scene& scene, std::span<const double> volumes);

// The same where the film's volumes are not known yet.
std::vector<double> whole_cells(const scene::Scene& scene, const film::Unfolding& unfolding);

}  // namespace lamella::energy
