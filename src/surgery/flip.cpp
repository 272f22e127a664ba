#include "surgery/flip.h"

#include <array>
#include <vector>

#include "energy/triangle.h"
#include "film/ring.h"

namespace lamella::surgery {

using film::Edge;
using film::EdgeEnd;
using film::ElementKind;
using film::Film;
using film::RegionPair;
using film::Side;
using film::SignedEdge;
using film::Triangle;
using film::Vec3;
using film::Vertex;

namespace {

bool is_set(const Film& film, ElementKind kind, std::uint32_t row) {
  const auto fixed = film.columns(kind).flags("fixed");
  return !fixed.empty() && fixed[row] != 0;
}

bool same_tension(const Film& film, Triangle a, Triangle b) {
  const auto tension = film.columns(ElementKind::facet).reals("tension");
  return tension.empty() || tension[a.index] == tension[b.index];
}

SignedEdge edge_at(const Film& film, Side s, int steps) {
  return film.edges(s.triangle())[static_cast<std::size_t>((s.corner() + steps) % 3)];
}

}  // namespace

std::optional<Diagonal> flippable(const Film& film, Edge edge) {
  const Side first = film.first_side(edge);
  if (!first.valid()) return {};
  const Side second = film.next_around(first);
  if (second == first || film.next_around(second) != first) return {};
  const SignedEdge walked = film.edge_of(first);
  const Diagonal d{
      edge, first, second, film.tail(walked), film.head(walked), film.opposite(first), film.opposite(second)};
  const bool opposed = walked.reversed() != film.edge_of(second).reversed();
  const RegionPair pair = film.regions(second.triangle());
  if (d.r == d.w || !(film.regions(first.triangle()) == (opposed ? pair : pair.flipped()))) return {};
  if (is_set(film, ElementKind::edge, edge.index) ||
      is_set(film, ElementKind::facet, first.triangle().index) ||
      is_set(film, ElementKind::facet, second.triangle().index)) {
    return {};
  }
  if (!same_tension(film, first.triangle(), second.triangle()) || film.find_edge(d.r, d.w).valid()) return {};
  return d;
}

std::array<Vec3, 4> places(const Film& film, const Diagonal& d) {
  if (!film.periodic())
    return {film.position(d.p), film.position(d.q), film.position(d.r), film.position(d.w)};
  const Vec3 tail = film.position(film.ends(d.edge)[0]);
  const Vec3 head = tail + film.vector(d.edge);
  const bool along = !film.edge_of(d.first).reversed();
  return {along ? tail : head, along ? head : tail, tail + film::apex_direction(film, d.first),
          tail + film::apex_direction(film, d.second)};
}

bool flip_is_flat(const Film& film, const Diagonal& d) {
  const auto [p, q, r, w] = places(film, d);
  const auto area = energy::double_area_vector;
  const Vec3 mean = unit(area(p, q, r) + area(q, p, w));
  const Vec3 at_p = unit(area(p, w, r));
  const Vec3 at_q = unit(area(w, q, r));
  return dot(at_p, mean) > 0.5 && dot(at_q, mean) > 0.5;
}

void flip(Film& film, const Diagonal& d) {
  const bool opposed = film.edge_of(d.first).reversed() != film.edge_of(d.second).reversed();
  // The first facet stays at the edge's tail, which is q where the facet walks the edge backward.
  const bool backward = film.edge_of(d.first).reversed();
  const Triangle first = d.first.triangle();
  const Triangle second = d.second.triangle();
  const Triangle at_p = backward ? second : first;
  const Triangle at_q = backward ? first : second;
  // The four outer edges with the sides along them, walked p-w, w-q, q-r, r-p. The second facet, walked
  // against the first, runs q-p, p-w, w-q; walked along it, p-q, q-w, w-p.
  struct Outer {
    SignedEdge edge;
    Side old;
    Side made;
  };
  const auto side = [](Side s, int steps) { return Side(s.triangle(), (s.corner() + steps) % 3); };
  const SignedEdge pw = opposed ? edge_at(film, d.second, 1) : -edge_at(film, d.second, 2);
  const SignedEdge wq = opposed ? edge_at(film, d.second, 2) : -edge_at(film, d.second, 1);
  const std::array<Outer, 4> outer{{{pw, side(d.second, opposed ? 1 : 2), Side(at_p, 2)},
                                    {wq, side(d.second, opposed ? 2 : 1), Side(at_q, 1)},
                                    {edge_at(film, d.first, 1), side(d.first, 1), Side(at_q, 2)},
                                    {edge_at(film, d.first, 2), side(d.first, 2), Side(at_p, 1)}}};
  // Sides change hands among the two facets, so the rings are read before any is written.
  std::array<std::vector<Side>, 4> rings;
  for (std::size_t i = 0; i < 4; ++i) {
    rings[i] = film::ring_with(film, outer[i].edge.edge(), outer[i].old, outer[i].made);
  }
  const auto at = places(film, d);
  film.reattach(EdgeEnd(d.edge, 0), d.w);
  film.reattach(EdgeEnd(d.edge, 1), d.r);
  film.aim(SignedEdge(d.edge, false), at[2] - at[3]);
  film.rewrite(at_p, {SignedEdge(d.edge, false), outer[3].edge, outer[0].edge});
  film.rewrite(at_q, {SignedEdge(d.edge, true), outer[1].edge, outer[2].edge});
  if (!opposed) film.set_regions(second, film.regions(first));
  for (std::size_t i = 0; i < 4; ++i) film.set_ring(outer[i].edge.edge(), rings[i]);
  film.set_ring(d.edge, std::array{Side(first, 0), Side(second, 0)});
}

}  // namespace lamella::surgery
