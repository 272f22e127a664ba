// Solves for the multipliers of volume constraints: a small symmetric system, one row a body.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "energy/volume_gradient.h"

namespace lamella::solve {

// Factorises G W G^T. Up to a few dozen rows by a dense factorisation; beyond that sparse, with the symbolic
// part kept for the life of the solver. A row without any gradient (a body none of whose vertices may move)
// leaves the others untouched.
class GramSolver {
 public:
  enum class Kind : std::uint8_t {
    factors,  // always
    fastest,  // beyond some two hundred rows by conjugate gradients
  };
  GramSolver(int rows, const std::vector<energy::GramEntry>& pattern, Kind kind = Kind::factors);
  ~GramSolver();
  GramSolver(GramSolver&&) noexcept;
  GramSolver& operator=(GramSolver&&) noexcept;

  // `values` in the order of the pattern. False if the matrix is singular: some bodies' volumes cannot be
  // changed independently.
  bool factorise(std::span<const double> values);
  // `enough` is what iterations may leave of any row of the right-hand side; 0 for 1e-9 of the whole.
  void solve(std::span<const double> right, std::span<double> multipliers, double enough = 0) const;

 private:
  struct Work;
  std::unique_ptr<Work> work_;
};

}  // namespace lamella::solve
