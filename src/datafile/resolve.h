// From numbers to rows: whether all that is referred to exists, and whether faces close.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "datafile/reading.h"
#include "film/ids.h"

namespace lamella::datafile {

// Rows instead of numbers. What is not defined is an invalid id.
struct Resolved {
  std::vector<std::array<film::Vertex, 2>> edge_ends;
  std::vector<film::SignedEdge> loops;       // parallel to Rows::loops.ids
  std::vector<film::Triangle> body_faces;    // parallel to Rows::body_faces.ids, without signs
  std::vector<std::uint8_t> sound_faces;     // faces with a closed loop of three edges or more
  std::vector<std::uint32_t> faces_at_edge;  // how many sides of faces each edge has

  film::Vertex tail(film::SignedEdge e) const { return edge_ends[e.edge().index][e.reversed() ? 1 : 0]; }
  film::Vertex head(film::SignedEdge e) const { return edge_ends[e.edge().index][e.reversed() ? 0 : 1]; }
};

// Notes every number that is defined twice or not at all, edges with equal ends, and loops that do not close.
Resolved resolve(Reading& reading);

}  // namespace lamella::datafile
