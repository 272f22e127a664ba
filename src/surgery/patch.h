// Facets taken out of a film and others put in their place.
#pragma once

#include <array>
#include <vector>

#include "film/film.h"

namespace lamella::surgery {

// A facet to be made, by its corners; what it does not say is inherited from another, which may be one that
// goes.
struct NewFacet {
  std::array<film::Vertex, 3> corners;
  film::RegionPair regions;
  film::Triangle like;
};

struct Patch {
  std::vector<film::Triangle> gone;
  std::vector<NewFacet> made;
};

// Edges between the corners of new facets are made where the film has none. Edges and vertices of facets that
// go are removed if nothing is left at them, except wires: edges and vertices that are fixed or on a
// boundary. The films around each edge touched are put into their order by the present positions. Returns the
// new facets.
std::vector<film::Triangle> replace(film::Film& film, const Patch& patch);

// A vertex like another in every column, at a point.
film::Vertex copy_vertex(film::Film& film, film::Vertex like, const film::Vec3& point);

// Whether an element of a kind is flagged fixed.
bool is_fixed(const film::Film& film, film::ElementKind kind, std::uint32_t row);

// Every facet with a corner among some vertices, once, in ascending order.
std::vector<film::Triangle> facets_at(const film::Film& film, std::span<const film::Vertex> vertices);

}  // namespace lamella::surgery
