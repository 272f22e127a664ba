#include "solve/cotangent.h"

#include <algorithm>

#include "film/unfolding.h"

namespace lamella::solve {

using film::Vec3;

double cotangent_weights(const film::Film& film, std::span<const double> tension, std::span<const Vec3> x,
                         std::span<double> edge_weight, std::span<double> vertex_mass) {
  std::fill(edge_weight.begin(), edge_weight.end(), 0.0);
  std::fill(vertex_mass.begin(), vertex_mass.end(), 0.0);
  double total_area = 0;
  const film::Connectivity& c = film.connectivity();
  for (std::size_t t = 0; t < c.triangle_vertices.size(); ++t) {
    const auto& corner = c.triangle_vertices[t];
    const double sigma = tension.empty() ? 1.0 : tension[t];
    const auto [p0, p1, p2] = film::points_at(film, film::Triangle(t), x);
    const double doubled = length(cross(p1 - p0, p2 - p0));
    if (!(doubled > 0)) continue;
    const double half = 0.5 * sigma / doubled;
    edge_weight[c.triangle_edges[t][0].edge().index] += half * dot(p0 - p2, p1 - p2);
    edge_weight[c.triangle_edges[t][1].edge().index] += half * dot(p1 - p0, p2 - p0);
    edge_weight[c.triangle_edges[t][2].edge().index] += half * dot(p2 - p1, p0 - p1);
    total_area += doubled / 2;
    for (const film::Vertex v : corner) vertex_mass[v.index] += sigma * doubled / 6;
  }
  return total_area;
}

}  // namespace lamella::solve
