// Formulas of coordinates, compiled once to values and exact derivatives: level sets, parametric curves,
// densities.
//
// An expression becomes a list of instructions on registers. Run with jets instead of numbers (a value with
// its gradient and Hessian with respect to up to three coordinates), the same list gives exact derivatives:
// forward differentiation. Gradients at many points at once go backward.
#pragma once

#include <array>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "language/expression.h"
#include "language/variables.h"

namespace lamella::language {

// A value with first and second derivatives by three coordinates. Hessian: xx, xy, xz, yy, yz, zz.
struct Jet {
  double value = 0;
  std::array<double, 3> gradient{};
  std::array<double, 6> hessian{};
};

// Points that a formula is evaluated at side by side.
inline constexpr std::size_t lane_count = 16;
using Lanes = std::array<double, lane_count>;

// A value with its gradient by three coordinates.
template <class T>
struct First {
  T value{};
  std::array<T, 3> gradient{};
};

// What a formula may depend on besides its coordinates and the scene's variables, in the order of its local
// slots.
struct FormulaInputs {
  std::span<const double> coordinates;  // three: x, y, z or p1, p2, p3; or six, with those of a normal
  double time = 0;                      // total_time
  std::span<const double> attributes;   // values of `Formula::attributes()` at the element in question
  std::array<int, 3> by = {0, 1, 2};    // the coordinates by which derivatives are taken
};

struct FormulaProgram;

class Formula {
 public:
  Formula() = default;
  // `expression` was parsed in a FormulaScope; `attributes` are the names it declared. Throws text::Error
  // with the place of whatever has no derivative or is out of place in a formula (elements, strings,
  // aggregates).
  Formula(std::shared_ptr<const Expression> expression, std::string text,
          std::vector<std::string> attributes);

  explicit operator bool() const { return program_ != nullptr; }
  const std::string& text() const { return text_; }
  // Vertex attributes that the formula reads.
  const std::vector<std::string>& attributes() const { return attributes_; }
  bool depends_on_time() const;
  bool depends_on_variables() const;
  // The variables of the scene that the formula reads.
  std::span<const VariableId> variables() const;

  // The present values of the variables that the formula reads; needed before the first evaluation, and after
  // a variable has changed. Undefined variables count as 0. `gravity` is what G stands for.
  void bind(const Variables& variables, double gravity = 0);

  // Not a number where the formula has no value (a square root of a negative number, a division by zero).
  double value(const FormulaInputs& inputs) const;
  // Value and gradient; the Hessian is left 0.
  Jet gradient(const FormulaInputs& inputs) const;
  Jet hessian(const FormulaInputs& inputs) const;

  // The same at `lane_count` points at once, for a formula that reads no attributes.
  Lanes values(const std::array<Lanes, 3>& coordinates, double time) const;
  First<Lanes> gradients(const std::array<Lanes, 3>& coordinates, double time) const;

 private:
  void find_uniform(std::span<const double> variables, double gravity);

  std::shared_ptr<const FormulaProgram> program_;
  std::string text_;
  std::vector<std::string> attributes_;
  std::vector<double> uniform_;  // the values of what is the same everywhere, in the program's order
};

}  // namespace lamella::language
