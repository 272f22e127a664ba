// A formula as a list of instructions on registers.
#pragma once

#include <cstdint>
#include <vector>

#include "language/expression.h"
#include "language/function_derivatives.h"
#include "language/variables.h"

namespace lamella::language {

// Instruction i writes register i; operands are earlier registers. What depends neither on the place nor on
// the time is uniform: it is found once, when variables are bound.
struct FormulaProgram {
  enum class Kind : std::uint8_t {
    constant,
    coordinate,
    time,
    gravity,
    attribute,
    variable,
    negate,
    logical_not,
    add,
    subtract,
    multiply,
    divide,
    whole_power,  // to the constant exponent
    unary,
    binary,
    operation,
    choose,
  };
  struct Instruction {
    Kind kind = Kind::constant;
    BinaryOperator operation = BinaryOperator::add;
    std::uint32_t a = 0;  // a register, or a row among coordinates, attributes or variables
    std::uint32_t b = 0;
    std::uint32_t c = 0;
    int exponent = 0;
    double constant = 0;
    UnaryRule unary = nullptr;
    BinaryRule binary = nullptr;
  };
  std::vector<Instruction> instructions;
  std::vector<VariableId> variables;
  std::vector<std::uint32_t> uniform;  // instructions, in order
  std::vector<std::uint32_t> varying;
  std::vector<std::uint32_t> loaded;  // uniform registers that varying instructions, or the result, read
};

// The program of an expression that was parsed in a FormulaScope with so many attributes. Throws text::Error
// with the place of what a formula cannot contain.
FormulaProgram compile_formula(const Expression& expression, std::size_t attributes);

}  // namespace lamella::language
