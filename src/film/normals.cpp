#include "film/normals.h"

#include "film/unfolding.h"

namespace lamella::film {

std::vector<Vec3> area_vectors(const Film& film, std::span<const Vec3> positions) {
  std::vector<Vec3> result(film.vertex_rows());
  for (std::uint32_t t = 0; t < film.triangle_rows(); ++t) {
    const auto& corner = film.corners(Triangle(t));
    if (!corner[0].valid()) continue;
    const auto [a, b, c] = points_at(film, Triangle(t), positions);
    const Vec3 area = 0.5 * cross(b - a, c - a);
    for (const Vertex v : corner) {
      Vec3& sum = result[v.index];
      sum += dot(sum, area) < 0 ? -area : area;
    }
  }
  return result;
}

}  // namespace lamella::film
