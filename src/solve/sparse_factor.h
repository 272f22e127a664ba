// Factorisation of a large sparse symmetric matrix as L D L^T. The one file that knows SuiteSparse.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "film/vec3.h"
#include "solve/lower_matrix.h"

namespace lamella::solve {

class FrontalFactor;

// The symbolic part of the last large factorisation, for a later one of the same pattern: commands that come
// one after another work on one mesh. Holds no values.
class SymbolicMemory {
 private:
  friend class SparseFactor;
  std::vector<int> column_start_;
  std::vector<int> row_;
  std::shared_ptr<FrontalFactor> fronts_;
};

// The symbolic part is made once for a pattern, and kept while only values change.
class SparseFactor {
 public:
  // `places`, a point a row where they are known, make for a better order of large matrices (rows beyond them
  // are multipliers, see solve/dissection.h).
  // With a memory the symbolic part is taken from there if that is of the same pattern and not in use, and
  // left there.
  explicit SparseFactor(const LowerMatrix& pattern, std::span<const film::Vec3> places = {},
                        SymbolicMemory* memory = nullptr);
  ~SparseFactor();
  SparseFactor(SparseFactor&&) noexcept;
  SparseFactor& operator=(SparseFactor&&) noexcept;

  // False if a pivot vanishes or is not a number. There is no pivoting: an indefinite matrix factorises well
  // as long as no leading part of it, in the order of elimination, is nearly singular.
  bool factorise(const LowerMatrix& matrix);
  // Of the last factorisation: how many eigenvalues of the matrix are negative (Sylvester's law of inertia).
  int negative_pivots() const;
  // Solves for `columns` right-hand sides stored one after another, in place.
  void solve(std::span<double> values, int columns);

 private:
  struct Work;
  std::unique_ptr<Work> work_;
};

}  // namespace lamella::solve
