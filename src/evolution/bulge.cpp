#include "evolution/bulge.h"

#include "film/normals.h"
#include "film/vertex_place.h"

namespace lamella::evolution {

namespace {

using film::Edge;
using film::Film;
using film::PlaceKind;
using film::SignedEdge;
using film::Vec3;
using film::VertexPlace;

// An edge that would bulge by more than this part of its length says nothing about curvature.
constexpr double most = 0.15;

// The cubic that leaves both ends at right angles to the normals there; the parabola where one normal is
// known.
Vec3 inside(const Vec3& along, const Vec3* at_tail, const Vec3* at_head) {
  const Vec3 tail = at_tail != nullptr ? dot(along, *at_tail) * *at_tail : Vec3{};
  const Vec3 head = at_head != nullptr ? dot(along, *at_head) * *at_head : Vec3{};
  const double weight = at_tail != nullptr && at_head != nullptr ? 0.125 : 0.25;
  return weight * (head - tail);
}

// The edge of the line that goes on beyond an end of this one; not valid where it ends or bends off.
SignedEdge onward(const VertexPlace& place, Edge from) {
  if (place.kind != PlaceKind::line) return {};
  return place.edges[0].edge() == from ? place.edges[1] : place.edges[0];
}

// By the points before and after: the cubic through four, the parabola through three.
Vec3 on_line(const Film& film, Edge e, const VertexPlace& tail, const VertexPlace& head) {
  const Vec3 along = film.vector(e);
  const SignedEdge before = onward(tail, e);
  const SignedEdge after = onward(head, e);
  // Second differences at the ends.
  const bool has_before = tail.kind == PlaceKind::line;
  const bool has_after = head.kind == PlaceKind::line;
  const Vec3 at_tail = has_before ? film.vector(before) + along : Vec3{};
  const Vec3 at_head = has_after ? film.vector(after) - along : Vec3{};
  const double weight = has_before && has_after ? 1.0 / 16 : 1.0 / 8;
  return -weight * (at_tail + at_head);
}

}  // namespace

std::vector<Vec3> bulges(const Film& film) {
  const std::vector<Vec3> areas = film::area_vectors(film, film.positions());
  std::vector<VertexPlace> places(film.vertex_rows());
  std::vector<Vec3> normals(film.vertex_rows());
  for (std::uint32_t v = 0; v < film.vertex_rows(); ++v) {
    places[v] = film::place_of(film, film::Vertex(v));
    normals[v] = unit(areas[v]);
  }
  const auto fixed = film.columns(film::ElementKind::vertex).flags("fixed");
  const auto fixed_edge = film.columns(film::ElementKind::edge).flags("fixed");
  const auto known = [&](film::Vertex v) {
    return places[v.index].kind == PlaceKind::inside ? &normals[v.index] : nullptr;
  };
  std::vector<Vec3> result(film.edge_rows());
  for (std::uint32_t i = 0; i < result.size(); ++i) {
    const Edge e(i);
    if (!fixed_edge.empty() && fixed_edge[i] != 0) continue;
    const auto [tail, head] = film.ends(e);
    const int films = film.valence(e);
    const bool held = !fixed.empty() && fixed[tail.index] != 0 && fixed[head.index] != 0;
    Vec3 bulge;
    if (films == 2) bulge = inside(film.vector(e), known(tail), known(head));
    if (films > 2 && !held) bulge = on_line(film, e, places[tail.index], places[head.index]);
    if (squared_length(bulge) < most * most * squared_length(film.vector(e))) result[i] = bulge;
  }
  return result;
}

}  // namespace lamella::evolution
