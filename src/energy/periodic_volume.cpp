#include "energy/periodic_volume.h"

#include <cmath>

#include "energy/sweep.h"

namespace lamella::energy {

std::vector<double> whole_cells(const scene::Scene& scene, std::span<const double> volumes) {
  std::vector<double> added(volumes.size());
  if (scene.strings.on) return added;  // cells are measured whole
  const double cell = scene.film.lattice()->volume();
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    const scene::Body& body = scene.bodies[b];
    const double here = volumes[b + 1] + body.volume_offset;
    // Rounding may leave an empty region a little below nothing.
    const double multiple = body.target_volume ? std::round((*body.target_volume - here) / cell)
                                               : -std::floor(here / cell + 1e-9);
    added[b + 1] = multiple * cell;
  }
  return added;
}

std::vector<double> whole_cells(const scene::Scene& scene, const film::Unfolding& unfolding) {
  std::vector<double> volumes(scene.bodies.size() + 1);
  if (scene.bodies.empty() || scene.strings.on) return volumes;
  std::vector<film::Vec3> extended;
  SweepInput input;
  input.positions = unfolding.extend(scene.film.positions(), extended);
  input.triangles = unfolding.triangles();
  input.regions = scene.film.connectivity().triangle_regions;
  input.has_regions = true;
  if (!extended.empty()) input.origin = extended[0];
  sweep_energy(input, volumes);
  unfolding.add_volumes(extended, input.origin, volumes);
  return whole_cells(scene, volumes);
}

}  // namespace lamella::energy
