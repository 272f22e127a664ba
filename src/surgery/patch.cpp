#include "surgery/patch.h"

#include <algorithm>

#include "scene/constraint.h"

namespace lamella::surgery {

using film::Edge;
using film::EdgeEnd;
using film::ElementKind;
using film::Film;
using film::Side;
using film::SignedEdge;
using film::Triangle;
using film::Vertex;

namespace {

template <class Id>
void make_unique(std::vector<Id>& ids) {
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
}

bool is_wire(const Film& film, Edge e) {
  if (is_fixed(film, ElementKind::edge, e.index)) return true;
  const film::Column* boundary = film.columns(ElementKind::edge).find(scene::boundary_column);
  return boundary != nullptr && boundary->value(e.index) != 0;
}

SignedEdge edge_between(Film& film, Vertex from, Vertex to, Triangle like) {
  const SignedEdge found = film.find_edge(from, to);
  if (found.valid()) return found;
  const Edge made = film.add_edge(from, to);
  film.inherit(made, like);
  return SignedEdge(made, false);
}

}  // namespace

bool is_fixed(const Film& film, ElementKind kind, std::uint32_t row) {
  const auto fixed = film.columns(kind).flags("fixed");
  return !fixed.empty() && fixed[row] != 0;
}

Vertex copy_vertex(Film& film, Vertex like, const film::Vec3& point) {
  const Vertex made = film.add_vertex(point);
  film.columns(ElementKind::vertex).edit_each([&](film::Column& column) {
    column.copy_row(like.index, made.index);
  });
  return made;
}

std::vector<Triangle> facets_at(const Film& film, std::span<const Vertex> vertices) {
  std::vector<Triangle> facets;
  for (const Vertex v : vertices) {
    film.for_each_end(v, [&](EdgeEnd end) {
      film.for_each_side(end.edge(), [&](Side s) { facets.push_back(s.triangle()); });
    });
  }
  make_unique(facets);
  return facets;
}

std::vector<Triangle> replace(Film& film, const Patch& patch) {
  std::vector<Edge> edges;
  std::vector<Vertex> vertices;
  for (const Triangle t : patch.gone) {
    for (std::size_t k = 0; k < 3; ++k) {
      edges.push_back(film.edges(t)[k].edge());
      vertices.push_back(film.corners(t)[k]);
    }
    film.remove(t);
  }
  std::vector<Triangle> made;
  for (const NewFacet& facet : patch.made) {
    std::array<SignedEdge, 3> sides;
    for (std::size_t k = 0; k < 3; ++k) {
      sides[k] = edge_between(film, facet.corners[k], facet.corners[(k + 1) % 3], facet.like);
      edges.push_back(sides[k].edge());
    }
    made.push_back(film.add_triangle(sides, facet.regions));
    film.inherit(made.back(), facet.like);
  }
  make_unique(edges);
  make_unique(vertices);
  for (const Edge e : edges) {
    if (film.first_side(e).valid()) {
      film.sort_sides(e);
    } else if (!is_wire(film, e)) {
      film.remove(e);
    }
  }
  for (const Vertex v : vertices) {
    if (!film.first_end(v).valid() && !is_fixed(film, ElementKind::vertex, v.index)) film.remove(v);
  }
  return made;
}

}  // namespace lamella::surgery
