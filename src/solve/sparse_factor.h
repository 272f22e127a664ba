// Factorisation of a large sparse symmetric matrix as L D L^T. The one file that knows SuiteSparse.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "film/vec3.h"
#include "solve/lower_matrix.h"

namespace lamella::solve {

// The symbolic part is made once for a pattern, and kept while only values change.
class SparseFactor {
 public:
  // `places`, a point a row where they are known, make for a better order of large matrices (rows beyond them
  // are multipliers, see solve/dissection.h).
  explicit SparseFactor(const LowerMatrix& pattern, std::span<const film::Vec3> places = {});
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
