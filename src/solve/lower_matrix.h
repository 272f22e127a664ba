// Half of a sparse symmetric matrix.
#pragma once

#include <vector>

namespace lamella::solve {

// The lower triangle of a symmetric matrix by columns (compressed): the diagonal entry comes first in each
// column.
struct LowerMatrix {
  std::vector<int> column_start;  // one more than there are columns
  std::vector<int> row;
  std::vector<double> value;

  int size() const { return static_cast<int>(column_start.size()) - 1; }
};

}  // namespace lamella::solve
