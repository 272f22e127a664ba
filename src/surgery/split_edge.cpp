#include "surgery/split_edge.h"

#include <array>
#include <utility>
#include <vector>

#include "film/ring.h"

namespace lamella::surgery {

using film::Edge;
using film::EdgeEnd;
using film::Film;
using film::Side;
using film::SignedEdge;
using film::Triangle;
using film::Vertex;

namespace {

struct Halves {
  Edge tail;
  Edge head;
};

// The two sides along the halves of a cut facet.
struct Cut {
  Side tail;
  Side head;
};

// Cuts the facet that has side `s` along the edge from the edge's middle m to the apex. The facet becomes the
// part at the edge's head; the part at its tail is new, and comes first around the cut. Which part is new,
// the direction of the cut and where the loops begin are the elder program's, so that scripts find the same
// numbers. `from_tail` leads from the edge's tail to the middle.
Cut cut_facet(Film& film, Side s, Vertex middle, Halves half, const film::Vec3& from_tail) {
  const Triangle t = s.triangle();
  const int k1 = film::next_corner(s.corner());
  const int k2 = film::previous_corner(s.corner());
  const bool along = !film.edge_of(s).reversed();
  const SignedEdge next = film.edges(t)[static_cast<std::size_t>(k1)];
  const SignedEdge previous = film.edges(t)[static_cast<std::size_t>(k2)];

  const Edge inner = film.add_edge(middle, film.opposite(s));
  film.inherit(inner, t);
  film.aim(SignedEdge(inner, false), (along ? -film.vector(previous) : film.vector(next)) - from_tail);
  using Loop = std::array<SignedEdge, 3>;
  const Loop at_tail = along ? Loop{SignedEdge(half.tail, false), SignedEdge(inner, false), previous}
                             : Loop{SignedEdge(half.tail, true), next, SignedEdge(inner, true)};
  const Loop at_head = along ? Loop{SignedEdge(inner, true), SignedEdge(half.head, false), next}
                             : Loop{SignedEdge(inner, false), previous, SignedEdge(half.head, true)};
  const Triangle part = film.add_unlinked_triangle(at_tail, film.regions(t));
  film.inherit(part, t);
  const SignedEdge gone = along ? previous : next;
  const SignedEdge kept = along ? next : previous;
  const auto gone_ring =
      film::ring_with(film, gone.edge(), Side(t, along ? k2 : k1), Side(part, along ? 2 : 1));
  const auto kept_ring = film::ring_with(film, kept.edge(), Side(t, along ? k1 : k2), Side(t, along ? 2 : 1));
  film.rewrite(t, at_head);
  film.set_ring(gone.edge(), gone_ring);
  film.set_ring(kept.edge(), kept_ring);
  film.set_ring(inner, std::array{Side(part, along ? 1 : 2), Side(t, 0)});
  return {Side(part, 0), Side(t, along ? 1 : 2)};
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
  std::vector<Side> head_sides;
  for (Side& s : sides) {
    const Cut cut = cut_facet(film, s, middle, {edge, head_half}, from_tail);
    s = cut.tail;
    head_sides.push_back(cut.head);
  }
  if (head_sides.size() == 2) std::swap(head_sides[0], head_sides[1]);
  film.set_ring(edge, sides);
  film.set_ring(head_half, head_sides);
  return middle;
}

Vertex split_edge(Film& film, Edge edge) {
  const film::Vec3& tail = film.position(film.ends(edge)[0]);
  return split_edge(film, edge, tail + 0.5 * film.vector(edge));
}

}  // namespace lamella::surgery
