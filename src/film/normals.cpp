#include "film/normals.h"

namespace lamella::film {

std::vector<Vec3> area_vectors(const Film& film, std::span<const Vec3> positions) {
  std::vector<Vec3> result(film.vertex_rows());
  for (std::uint32_t t = 0; t < film.triangle_rows(); ++t) {
    const auto& corner = film.corners(Triangle(t));
    if (!corner[0].valid()) continue;
    const Vec3& a = positions[corner[0].index];
    Vec3 to_b = positions[corner[1].index] - a;
    Vec3 to_c = positions[corner[2].index] - a;
    if (film.periodic()) {
      const std::array<Wrap, 3> wrap = film.corner_wraps(Triangle(t));
      to_b += film.lattice()->shift(wrap[1]);
      to_c += film.lattice()->shift(wrap[2]);
    }
    const Vec3 area = 0.5 * cross(to_b, to_c);
    for (const Vertex v : corner) {
      Vec3& sum = result[v.index];
      sum += dot(sum, area) < 0 ? -area : area;
    }
  }
  return result;
}

}  // namespace lamella::film
