// The diagonal of two neighbouring facets of one film exchanged for the other.
#pragma once

#include <array>
#include <optional>

#include "film/film.h"

namespace lamella::surgery {

// An edge inside a film with the quadrilateral of its two facets: p and q are its ends, r and w the opposite
// corners, r that of the first side. Walked p, w, q, r the quadrilateral turns like the first facet.
struct Diagonal {
  film::Edge edge;
  film::Side first;
  film::Side second;
  film::Vertex p;
  film::Vertex q;
  film::Vertex r;
  film::Vertex w;
};

// The quadrilateral, if the edge may be flipped: exactly two facets, alike on both sides (regions, tension),
// no edge between r and w yet, nothing fixed.
std::optional<Diagonal> flippable(const film::Film& film, film::Edge edge);

// Makes r-w the diagonal. The edge and both facets keep their ids; the second facet turns like the first if
// it did not. Surface tension, colours and other columns stay with the ids.
void flip(film::Film& film, const Diagonal& diagonal);

// Where p, q, r and w lie, in one piece.
std::array<film::Vec3, 4> places(const film::Film& film, const Diagonal& diagonal);

// True if the flip leaves both facets with area and without a fold: each new normal stays within 60 degrees
// of the mean of the old two.
bool flip_is_flat(const film::Film& film, const Diagonal& diagonal);

}  // namespace lamella::surgery
