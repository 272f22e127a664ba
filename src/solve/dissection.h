// Matrices on films cut in pieces by planes, for an order in which to eliminate their rows.
#pragma once

#include <span>
#include <vector>

#include "film/vec3.h"
#include "solve/sparse_factor.h"

namespace lamella::solve {

// Nested dissection by geometry (A. George, SIAM Journal on Numerical Analysis 10, 1973): rows are parted by
// a plane through their places, along the longest side of the box around them, and those of one part that are
// tied to the other become the seam between; and so on with each part down to a few hundred rows. On a film
// seams are curves, and short. It leaves about as much fill as dissection by the graph alone and is found
// several times as fast.
//
// `places` has one point a row; rows beyond are multipliers of constraints, which follow all rows that they
// are tied to. Returns for each row the number of its piece, in order of elimination.
std::vector<int> dissection(const LowerMatrix& pattern, std::span<const film::Vec3> places);

}  // namespace lamella::solve
