#include "session/element_access.h"

#include <algorithm>

#include <fmt/format.h>

#include "text/error.h"

namespace lamella::session {

using film::Edge;
using film::Film;
using film::Region;
using film::Side;
using film::SignedEdge;
using film::Triangle;
using film::Vertex;
using language::Element;
using language::ElementKind;

namespace {

Element vertex(Vertex v) {
  return {ElementKind::vertex, v.index, false};
}
Element edge(SignedEdge e) {
  return {ElementKind::edge, e.edge().index, e.reversed()};
}
Element facet(Triangle t, bool reversed) {
  return {ElementKind::facet, t.index, reversed};
}
SignedEdge signed_edge(const Element& element) {
  return {Edge(element.row), element.reversed};
}

// The edges of a facet in the order in which they run around it.
std::array<SignedEdge, 3> edges_around(const Film& film, const Element& element) {
  const std::array<SignedEdge, 3>& edges = film.edges(Triangle(element.row));
  if (!element.reversed) return edges;
  return {-edges[0], -edges[2], -edges[1]};
}

std::vector<Element> vertex_parts(const Film& film, Vertex v, ElementKind kind) {
  std::vector<Element> result;
  film.for_each_end(v, [&](film::EdgeEnd end) {
    if (kind == ElementKind::edge) {
      result.push_back(edge(end.outward()));
      return;
    }
    film.for_each_side(end.edge(), [&](Side s) {
      const Element found = facet(s.triangle(), false);
      if (std::find(result.begin(), result.end(), found) == result.end()) result.push_back(found);
    });
  });
  return result;
}

std::vector<Element> edge_parts(const Film& film, const Element& element, ElementKind kind) {
  const SignedEdge e = signed_edge(element);
  std::vector<Element> result;
  if (kind == ElementKind::vertex) return {vertex(film.tail(e)), vertex(film.head(e))};
  film.for_each_side(e.edge(), [&](Side s) { result.push_back(facet(s.triangle(), film.edge_of(s) != e)); });
  return result;
}

std::vector<Element> facet_parts(const scene::Scene& scene, const Element& element, ElementKind kind) {
  std::vector<Element> result;
  if (kind == ElementKind::body) {
    film::RegionPair regions = scene.film.regions(Triangle(element.row));
    if (element.reversed) regions = regions.flipped();
    for (const Region region : {regions.behind, regions.front}) {
      if (!region.outside()) result.push_back({ElementKind::body, region.index - 1, false});
    }
    return result;
  }
  for (const SignedEdge e : edges_around(scene.film, element)) {
    result.push_back(kind == ElementKind::edge ? edge(e) : vertex(scene.film.tail(e)));
  }
  return result;
}

// Puts rows in the order of their numbers, unless they are so already.
void sort_by_number(const scene::Scene& scene, ElementKind kind, std::vector<Element>& elements) {
  const auto by_number = [&](const Element& a, const Element& b) {
    return number_of(scene, kind, a.row) < number_of(scene, kind, b.row);
  };
  if (!std::is_sorted(elements.begin(), elements.end(), by_number)) {
    std::sort(elements.begin(), elements.end(), by_number);
  }
}

// All elements of a kind in the order of their numbers.
std::vector<Element> all_elements(const scene::Scene& scene, ElementKind kind) {
  std::vector<Element> result;
  const std::uint32_t rows = row_count(scene, kind);
  result.reserve(rows);
  for (std::uint32_t row = 0; row < rows; ++row) {
    if (is_alive(scene, kind, row)) result.push_back({kind, row, false});
  }
  sort_by_number(scene, kind, result);
  return result;
}

}  // namespace

std::uint32_t row_count(const scene::Scene& scene, ElementKind kind) {
  switch (kind) {
    case ElementKind::vertex:
      return scene.film.vertex_rows();
    case ElementKind::edge:
      return scene.film.edge_rows();
    case ElementKind::facet:
      return scene.film.triangle_rows();
    case ElementKind::body:
      return static_cast<std::uint32_t>(scene.bodies.size());
  }
  return 0;
}

bool is_alive(const scene::Scene& scene, ElementKind kind, std::uint32_t row) {
  switch (kind) {
    case ElementKind::vertex:
      return scene.film.alive(Vertex(row));
    case ElementKind::edge:
      return scene.film.alive(Edge(row));
    case ElementKind::facet:
      return scene.film.alive(Triangle(row));
    case ElementKind::body:
      return row < scene.bodies.size() && !scene.bodies[row].absent;
  }
  return false;
}

std::uint32_t number_of(const scene::Scene& scene, ElementKind kind, std::uint32_t row) {
  switch (kind) {
    case ElementKind::vertex:
      return scene.film.number(Vertex(row));
    case ElementKind::edge:
      return scene.film.number(Edge(row));
    case ElementKind::facet:
      return scene.film.number(Triangle(row));
    case ElementKind::body:
      return row + 1;
  }
  return 0;
}

void ElementIndex::refresh(const scene::Scene& scene) {
  if (revision_ == scene.film.connectivity_revision()) return;
  revision_ = scene.film.connectivity_revision();
  all_ = {};
  for (std::vector<std::uint32_t>& rows : rows_) rows.clear();
  body_facets_.clear();
}

std::shared_ptr<const std::vector<Element>> ElementIndex::all(const scene::Scene& scene, ElementKind kind) {
  // A body may vanish without a change to the film.
  if (kind == ElementKind::body)
    return std::make_shared<const std::vector<Element>>(all_elements(scene, kind));
  refresh(scene);
  auto& known = all_[static_cast<std::size_t>(kind)];
  if (!known) known = std::make_shared<const std::vector<Element>>(all_elements(scene, kind));
  return known;
}

std::optional<std::uint32_t> ElementIndex::row(const scene::Scene& scene, ElementKind kind,
                                               std::uint32_t number) {
  const auto fits = [&](std::uint32_t row) {
    return row < row_count(scene, kind) && is_alive(scene, kind, row) &&
           number_of(scene, kind, row) == number;
  };
  // The usual case: rows stand in the order of their numbers, none missing.
  if (number >= 1 && fits(number - 1)) return number - 1;
  if (kind == ElementKind::body || number == 0) return std::nullopt;
  refresh(scene);
  std::vector<std::uint32_t>& rows = rows_[static_cast<std::size_t>(kind)];
  if (rows.empty()) {
    for (const Element& element : *all(scene, kind)) {
      const std::uint32_t n = number_of(scene, kind, element.row);
      if (rows.size() <= n) rows.resize(n + 1, film::no_index);
      rows[n] = element.row;
    }
  }
  if (number < rows.size() && rows[number] != film::no_index && fits(rows[number])) return rows[number];
  return std::nullopt;
}

const std::vector<Element>& ElementIndex::facets_of_body(const scene::Scene& scene, std::uint32_t body_row) {
  refresh(scene);
  if (body_facets_.size() != scene.bodies.size()) {
    body_facets_.assign(scene.bodies.size(), {});
    for (const Element& element : *all(scene, ElementKind::facet)) {
      const film::RegionPair regions = scene.film.regions(Triangle(element.row));
      if (regions.front == regions.behind) continue;
      if (!regions.behind.outside()) body_facets_[regions.behind.index - 1].push_back(element);
      if (!regions.front.outside())
        body_facets_[regions.front.index - 1].push_back({ElementKind::facet, element.row, true});
    }
  }
  return body_row < body_facets_.size() ? body_facets_[body_row] : none_;
}

std::vector<Element> parts_of(const scene::Scene& scene, ElementIndex& index, const Element& element,
                              ElementKind kind) {
  const bool made_of_others = kind != element.kind;
  if (element.kind == ElementKind::vertex && (kind == ElementKind::edge || kind == ElementKind::facet)) {
    return vertex_parts(scene.film, Vertex(element.row), kind);
  }
  if (element.kind == ElementKind::edge && (kind == ElementKind::vertex || kind == ElementKind::facet)) {
    return edge_parts(scene.film, element, kind);
  }
  if (element.kind == ElementKind::facet && made_of_others) return facet_parts(scene, element, kind);
  if (element.kind == ElementKind::body && kind == ElementKind::facet)
    return index.facets_of_body(scene, element.row);
  throw text::Error(
      fmt::format("a {} has no {}", language::name_of(element.kind), language::plural_of(kind)));
}

}  // namespace lamella::session
