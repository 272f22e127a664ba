// The ways in which the films around a point can go on, told by the link alone.
#pragma once

#include <vector>

#include "surgery/link.h"

namespace lamella::surgery {

enum class Move {
  keep,   // one vertex
  part,   // one sector drawn away from the rest: a film where others met across it
  join,   // two sectors brought together by a film between them
  apart,  // a vertex for each component of the link
};

// A corner of a film that is to be made: one of the copies that replace the cluster, or a node of the link.
struct Corner {
  int copy = -1;
  int node = -1;
};

struct Piece {
  std::array<Corner, 3> corners;
  film::RegionPair regions;
  film::Triangle like;
};

struct Rearrangement {
  Move move = Move::keep;
  int copies = 1;
  std::vector<int> copy_of_arc;  // whose corner each arc's facet has
  std::vector<Piece> films;      // besides the arcs' facets
};

// `keep` always; `apart` where the link has several components; `part` for each sector, `join` for each pair
// of sectors where that has a meaning. Between a closed region and itself no film is made; between open ones
// there is, as they are different sides. The link must be sound.
std::vector<Rearrangement> rearrangements(const Link& link);

}  // namespace lamella::surgery
