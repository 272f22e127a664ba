#include "surgery/split_facet.h"

#include <array>

namespace lamella::surgery {

using film::Edge;
using film::Film;
using film::Side;
using film::SignedEdge;
using film::Triangle;
using film::Vertex;

Vertex split_facet(Film& film, Triangle facet) {
  const std::array<Vertex, 3> corner = film.corners(facet);
  const std::array<SignedEdge, 3> edge = film.edges(facet);
  const std::array<film::Vec3, 3> points = film.points(facet);
  const film::Vec3 middle = (points[0] + points[1] + points[2]) / 3;
  const Vertex centre = film.add_vertex(middle);
  film.inherit(centre, facet);
  std::array<Edge, 3> spoke;
  for (std::size_t k = 0; k < 3; ++k) {
    spoke[k] = film.add_edge(corner[k], centre);
    film.inherit(spoke[k], facet);
    film.aim(SignedEdge(spoke[k], false), middle - points[k]);
  }
  std::array<Triangle, 3> part{Triangle{}, Triangle{}, facet};
  for (std::size_t k = 0; k < 2; ++k) {
    part[k] = film.add_unlinked_triangle(
        {edge[k], SignedEdge(spoke[k + 1], false), SignedEdge(spoke[k], true)}, film.regions(facet));
    film.inherit(part[k], facet);
    film.replace_in_ring(edge[k].edge(), Side(facet, static_cast<int>(k)), Side(part[k], 0));
  }

  film.replace_in_ring(edge[2].edge(), Side(facet, 2), Side(facet, 1));
  film.rewrite(facet, {SignedEdge(spoke[2], true), edge[2], SignedEdge(spoke[0], false)});
  film.set_ring(spoke[0], std::array{Side(part[0], 2), Side(facet, 2)});
  film.set_ring(spoke[1], std::array{Side(part[0], 1), Side(part[1], 2)});
  film.set_ring(spoke[2], std::array{Side(part[1], 1), Side(facet, 0)});
  return centre;
}

}  // namespace lamella::surgery
