#include "film/normals.h"

namespace lamella::film {

std::vector<Vec3> area_vectors(const Film& film, std::span<const Vec3> positions) {
  std::vector<Vec3> result(film.vertex_rows());
  for (const auto& corner : film.connectivity().triangle_vertices) {
    if (!corner[0].valid()) continue;
    const Vec3& a = positions[corner[0].index];
    const Vec3 area = 0.5 * cross(positions[corner[1].index] - a, positions[corner[2].index] - a);
    for (const Vertex v : corner) {
      Vec3& sum = result[v.index];
      sum += dot(sum, area) < 0 ? -area : area;
    }
  }
  return result;
}

}  // namespace lamella::film
