// Rings of sides around edges, as surgery reads and writes them.
#pragma once

#include <vector>

#include "film/film.h"

namespace lamella::film {

// An edge's ring with one side in another's place. Where several rings change together all are read before
// any facet is written.
std::vector<Side> ring_with(const Film& film, Edge edge, Side old, Side made);

// Puts a side first around its edge if that has two: which of them is first decides how the edge turns when
// it is flipped. Rings of more have a geometric order, and stay.
void begin_ring(Film& film, Side side);

}  // namespace lamella::film
