#include "surgery/skinny.h"

#include <set>

#include "energy/triangle.h"
#include "film/normals.h"
#include "surgery/split_edge.h"
#include "surgery/split_facet.h"

namespace lamella::surgery {

using film::Edge;
using film::Film;
using film::Side;
using film::Triangle;
using film::Vec3;

namespace {

Edge longest_edge(const Film& film, Triangle t) {
  Edge longest;
  double most = -1;
  for (const film::SignedEdge& e : film.edges(t)) {
    const double here = length(film.vector(e));
    if (here <= most) continue;
    most = here;
    longest = e.edge();
  }
  return longest;
}

}  // namespace

std::uint32_t divide_skinny_facets(Film& film, double angle) {
  std::set<Edge> longest;
  for (std::uint32_t i = 0; i < film.triangle_rows(); ++i) {
    const Triangle t(i);
    if (!film.alive(t)) continue;
    const std::array<Vec3, 3> p = film.points(t);
    if (energy::smallest_angle(p[0], p[1], p[2]) < angle) longest.insert(longest_edge(film, t));
  }
  for (const Edge e : longest) split_edge(film, e);
  return static_cast<std::uint32_t>(longest.size());
}

double fold_angle(const Film& film, Edge e) {
  if (film.valence(e) != 2) return 0;
  const Side first = film.first_side(e);
  const Side second = film.next_around(first);
  const bool same_way = film.edge_of(first) != film.edge_of(second);
  const Vec3 a = film::double_area_vector(film, first.triangle());
  const Vec3 b = film::double_area_vector(film, second.triangle());
  return film::angle_between(a, same_way ? b : -b);
}

std::uint32_t notch_edges(Film& film, double angle) {
  std::set<Triangle> facets;
  for (std::uint32_t i = 0; i < film.edge_rows(); ++i) {
    const Edge e(i);
    if (!film.alive(e) || fold_angle(film, e) <= angle) continue;
    film.for_each_side(e, [&](Side s) { facets.insert(s.triangle()); });
  }
  for (const Triangle t : facets) split_facet(film, t);
  return static_cast<std::uint32_t>(facets.size());
}

}  // namespace lamella::surgery
