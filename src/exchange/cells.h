// The regions of space that films enclose, found from where the films are.
#pragma once

#include <vector>

#include "film/film.h"

namespace lamella::exchange {

struct Cells {
  std::uint32_t count = 0;                // regions besides the outside
  std::vector<film::RegionPair> regions;  // one a triangle row
};

// Two films that follow one another around an edge face the same space between them; faces that hang together
// so bound one region. Of the regions that a connected piece of film bounds one lies around it: the one whose
// volume, with normals outward, is least. That is a part of the innermost region of another piece that holds
// it, or else the outside. Regions are numbered by their first triangle. The film must be compact, with its
// sides in geometric order.
Cells find_cells(const film::Film& film);

}  // namespace lamella::exchange
