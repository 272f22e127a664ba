// Matrices on films cut in pieces by planes, for an order in which to eliminate their rows.
#pragma once

#include <span>
#include <vector>

#include "film/vec3.h"
#include "solve/lower_matrix.h"

namespace lamella::solve {

// A tree of pieces, each a seam between those below it, in order of elimination: a piece comes after those
// below it, and has ties with those below and above it alone.
struct Dissection {
  std::vector<int> piece;   // of each row
  std::vector<int> parent;  // of each piece, -1 for the last
};

// Nested dissection by geometry (A. George, SIAM Journal on Numerical Analysis 10, 1973): rows are parted by
// a plane across x, y or z, the one that ties the fewest rows on one side to the other among those that leave
// enough on either side; the fewest rows that hold all ties become the seam; and so on with each part, down
// to `small` rows. On a film seams are curves, and short. It leaves about as much work as dissection by the
// graph alone and is found several times as fast.
//
// `places` has one point a row; rows beyond are multipliers of constraints: each has a piece of its own,
// after all rows that it is tied to.
Dissection dissection(const LowerMatrix& pattern, std::span<const film::Vec3> places, std::size_t small);

}  // namespace lamella::solve
