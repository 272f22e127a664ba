// Second derivatives by free parameters: what borders the matrix of a Newton step.
#pragma once

#include <span>
#include <vector>

#include "solve/basis.h"
#include "solve/problem.h"

namespace lamella::solve {

// The Lagrangian is differentiated along the ways that vertices take when parameters change and constraints
// and boundaries carry them along; by central differences, as its first derivatives are.
struct ParameterBorder {
  // For each parameter: the mixed derivatives by it and the unknowns of the basis, then the derivatives of
  // the held values.
  std::vector<std::vector<double>> columns;
  std::vector<double> square;  // by two parameters, row by row
  std::vector<double> force;   // minus the derivative of the Lagrangian by each

  std::size_t size() const { return columns.size(); }
};

// Of the problem as it was last linearised at x; it is left linearised there. False in `ok` as for
// Problem::linearise.
ParameterBorder parameter_border(Problem& problem, const Basis& basis, std::span<const Vec3> x, bool& ok);

}  // namespace lamella::solve
