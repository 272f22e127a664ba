#include "surgery/split_edge.h"

#include <array>
#include <vector>

namespace lamella::surgery {

using film::Edge;
using film::EdgeEnd;
using film::Film;
using film::Side;
using film::SignedEdge;
using film::Triangle;
using film::Vertex;

namespace {

// Cuts the facet that has side `s` along the edge. Walked along that side its corners are p, q and the apex
// r; the middle m of pq parts it into (p, m, r) and (m, q, r). The facet becomes the part at the edge's tail,
// so that it keeps its side along the edge, which is now the tail half. Returns the other part's side along
// the head half. `from_tail` leads from the edge's tail to the middle.
Side cut_facet(Film& film, Side s, Vertex middle, Edge tail_half, Edge head_half,
               const film::Vec3& from_tail) {
  const Triangle t = s.triangle();
  const int k = s.corner();
  const int k1 = film::next_corner(k);
  const int k2 = film::previous_corner(k);
  const bool along = !film.edge_of(s).reversed();

  const film::Vec3 to_apex = along ? -film.vector(film.edges(t)[static_cast<std::size_t>(k2)])
                                   : film.vector(film.edges(t)[static_cast<std::size_t>(k1)]);
  const Edge inner = film.add_edge(middle, film.opposite(s));
  film.inherit(inner, t);
  film.aim(SignedEdge(inner, false), to_apex - from_tail);
  std::array<SignedEdge, 3> at_p = film.edges(t);
  std::array<SignedEdge, 3> at_q = film.edges(t);
  at_p[static_cast<std::size_t>(k)] = along ? SignedEdge(tail_half, false) : SignedEdge(head_half, true);
  at_p[static_cast<std::size_t>(k1)] = SignedEdge(inner, false);
  at_q[static_cast<std::size_t>(k)] = along ? SignedEdge(head_half, false) : SignedEdge(tail_half, true);
  at_q[static_cast<std::size_t>(k2)] = SignedEdge(inner, true);

  // The outer edge that goes over to the new part, and each part's side along the cut.
  const int outer = along ? k1 : k2;
  const int cut = along ? k2 : k1;
  const Edge outer_edge = film.edges(t)[static_cast<std::size_t>(outer)].edge();
  const Triangle part = film.add_unlinked_triangle(along ? at_q : at_p, film.regions(t));
  film.inherit(part, t);
  film.rewrite(t, along ? at_p : at_q);
  film.replace_in_ring(outer_edge, Side(t, outer), Side(part, outer));
  film.set_ring(inner, std::array{Side(t, outer), Side(part, cut)});
  return Side(part, k);
}

}  // namespace

Vertex split_edge(Film& film, Edge edge, const film::Vec3& point) {
  const Vertex tail = film.ends(edge)[0];
  const Vertex head = film.ends(edge)[1];
  const film::Vec3 along = film.vector(edge);
  const film::Vec3 from_tail = point - film.position(tail);
  std::vector<Side> sides;
  film.for_each_side(edge, [&](Side s) { sides.push_back(s); });

  const Vertex middle = film.add_vertex(point);
  film.inherit(middle, tail, head, edge);
  film.reattach(EdgeEnd(edge, 1), middle);
  const Edge head_half = film.add_edge(middle, head);
  film.inherit(head_half, edge);
  film.aim(SignedEdge(edge, false), from_tail);
  film.aim(SignedEdge(head_half, false), along - from_tail);
  for (Side& s : sides) s = cut_facet(film, s, middle, edge, head_half, from_tail);
  film.set_ring(head_half, sides);
  return middle;
}

Vertex split_edge(Film& film, Edge edge) {
  const film::Vec3& tail = film.position(film.ends(edge)[0]);
  return split_edge(film, edge, tail + 0.5 * film.vector(edge));
}

}  // namespace lamella::surgery
