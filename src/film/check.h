// Every invariant of the film complex, tested.
#pragma once

#include <string>
#include <vector>

#include "film/film.h"

namespace lamella::film {

// One sentence for each invariant that does not hold, naming the elements by the numbers people see; empty if
// the film is sound. Stops after `most` findings. Tested are: references in range and to live elements; rings
// around edges and vertices closed and complete, each element in exactly one; triangles' corners, edges and
// directions in agreement; distinct corners and edge ends; counts of tombstones; finite positions; columns
// as long as their elements; the geometric order of the sides around borders.
std::vector<std::string> check(const Film& film, std::size_t most = 20);

// The labels of regions around edges: the sector between two neighbouring sides must carry one region. A body
// that is not closed (a cap on a wire) breaks this lawfully, so it is told apart from `check`.
std::vector<std::string> check_regions(const Film& film, std::size_t most = 20);

}  // namespace lamella::film
