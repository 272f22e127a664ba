// The lowest point along a line.
#pragma once

#include <span>

#include "solve/problem.h"

namespace lamella::solve {

struct SeekResult {
  bool moved = false;
  double energy = 0;
  double scale = 0;  // how far along `way`; negative: against it
};

// Moves x along `way` (a row a vertex), volumes restored, to about the lowest energy on that line, and leaves
// it where it was if none is lower. The first trial is at `first`, shortened until the energy falls (on
// whichever side it falls more) or a millionth of it is reached, and then lengthened up to `longest` while it
// goes on falling. The problem must have been linearised at x.
SeekResult seek_lowest(Problem& problem, std::span<Vec3> x, std::span<const Vec3> way, double first,
                       double longest);

}  // namespace lamella::solve
