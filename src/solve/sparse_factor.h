// Factorisation of a large sparse symmetric positive definite matrix. The one file that knows SuiteSparse.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
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

// The symbolic part is made once for a pattern, and kept while only values change.
class SparseFactor {
 public:
  explicit SparseFactor(const LowerMatrix& pattern);
  ~SparseFactor();
  SparseFactor(SparseFactor&&) noexcept;
  SparseFactor& operator=(SparseFactor&&) noexcept;

  // False if the matrix is not positive definite.
  bool factorise(const LowerMatrix& matrix);
  // Solves for `columns` right-hand sides stored one after another, in place.
  void solve(std::span<double> values, int columns);

 private:
  struct Work;
  std::unique_ptr<Work> work_;
};

}  // namespace lamella::solve
