// Factorisation of a large sparse symmetric matrix as L D L^T by dense fronts.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "solve/dissection.h"
#include "solve/large_array.h"
#include "solve/lower_matrix.h"
#include "solve/spare_arrays.h"

namespace lamella::solve {

// The multifrontal method (I. Duff, J. Reid, ACM Transactions on Mathematical Software 9, 1983) on the tree
// of a dissection: each piece gathers its entries and what the pieces below it leave, eliminates its own
// rows, and hands on the rest. All arithmetic is in small dense matrices, and branches of the tree go in
// parallel; sums are made in the same order for any number of threads.
//
// The symbolic part is made once for a pattern. There is no pivoting.
class FrontalFactor {
 public:
  FrontalFactor(const LowerMatrix& pattern, const Dissection& pieces);

  // Gives back the memory of the last factorisation.
  void forget_values() {
    panels_ = {};
    spare_.clear();
  }

  // False if a pivot vanishes or is not a number.
  bool factorise(const LowerMatrix& matrix);
  // Of the last factorisation.
  int negative_pivots() const;
  // Right-hand sides one after another, in place.
  void solve(std::span<double> values, int columns);

 private:
  // A front: its own rows, first, and those above that they are tied to, by order of elimination.
  struct Front {
    int parent = -1;
    int own = 0;
    std::vector<int> rows;
    std::vector<int> children;
    std::vector<int> in_parent;  // where the rows that are not its own stand in the parent's
    // Entries of the matrix (by their places there) and where they go in the front, row and column.
    std::vector<std::array<int, 3>> entries;
    double work = 0;        // of the front and all below it
    std::size_t panel = 0;  // where its own columns of L stand, each as long as `rows`; D on the diagonal
    std::vector<double> update;  // what is handed on, square, its lower half
    bool sound = true;

    std::size_t size() const { return rows.size(); }
    std::size_t rest() const { return rows.size() - static_cast<std::size_t>(own); }
  };

  void find_rows(const LowerMatrix& pattern, const Dissection& pieces);
  void find_entries(const LowerMatrix& pattern, const Dissection& pieces);
  void climb(int front, const LowerMatrix& matrix);
  void eliminate_front(Front& front, const LowerMatrix& matrix);
  void assemble(Front& front, const LowerMatrix& matrix);

  double* panel(const Front& front) { return panels_.data() + front.panel; }
  const double* panel(const Front& front) const { return panels_.data() + front.panel; }

  std::vector<Front> fronts_;
  std::size_t panel_size_ = 0;  // of all panels
  LargeArray panels_;
  SpareArrays spare_;       // updates that are not in use
  std::vector<int> order_;  // of each row in the elimination
  double work_ = 0;
};

}  // namespace lamella::solve
