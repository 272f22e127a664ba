// Films of one dimension, the datafile's string model: edges carry the tension, and what a datafile calls
// faces are cells between them.
#pragma once

#include <vector>

#include "film/film.h"
#include "scene/constraint.h"

namespace lamella::scene {

struct Scene;

// A cell lies to the left of the edges that it has with a plus, seen from above. Its area counts in the
// volume of the region behind it, and against that of the region in front (as with facets, of whose lists of
// bodies it stands with a plus or a minus).
struct Cell {
  film::RegionPair regions;
  std::uint32_t original = 0;
};

struct StringModel {
  bool on = false;
  int dimension = 3;  // of space; in the plane, z is 0
  std::vector<Cell> cells;
  EdgeIntegrand area;    // the field whose integral around a cell is its area
  EdgeIntegrand height;  // and its moment against gravity, the integral of y over it
};

// The column of edges that tells their cells: so many integers in a row as an edge has cells at most, numbers
// of cells from 1, negative where the cell has the edge with a minus, 0 for none.
inline constexpr const char* cells_column = "cells";

// The model with its fields; not on yet.
StringModel make_string_model();

// The signed edges of each cell, each after the one that it begins at the end of, as far as there is one;
// back along the same edge only where nothing else is left.
std::vector<std::vector<film::SignedEdge>> loops_of_cells(const Scene& scene);

}  // namespace lamella::scene
