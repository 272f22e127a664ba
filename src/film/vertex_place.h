// Where in the film a vertex lies, by its edges.
#pragma once

#include <array>

#include "film/film.h"

namespace lamella::film {

enum class PlaceKind {
  inside,  // every edge has exactly two films around it
  line,    // exactly two edges have another number: a vertex on a border, a rim or a wire
  corner,  // anything else: a quad point, an end of a line, an isolated vertex
};

struct VertexPlace {
  PlaceKind kind = PlaceKind::corner;
  std::array<SignedEdge, 2> edges;  // of the line, outward
};

inline VertexPlace place_of(const Film& film, Vertex v) {
  VertexPlace place;
  int line_edges = 0;
  bool any = false;
  film.for_each_end(v, [&](EdgeEnd end) {
    any = true;
    const Side first = film.first_side(end.edge());
    if (first.valid()) {
      const Side second = film.next_around(first);
      if (second != first && film.next_around(second) == first) return;
    }
    if (line_edges < 2) place.edges[static_cast<std::size_t>(line_edges)] = end.outward();
    ++line_edges;
  });
  if (any && line_edges == 0) place.kind = PlaceKind::inside;
  if (line_edges == 2) place.kind = PlaceKind::line;
  return place;
}

}  // namespace lamella::film
