// First and second derivatives of the functions that formulas may call.
#pragma once

#include <optional>
#include <string_view>

#include "language/jet.h"

namespace lamella::language {

using UnaryRule = UnaryDerivatives (*)(double x);
using BinaryRule = SecondOrder (*)(double a, double b);

// Null for a function that formulas cannot differentiate. Outside their domain rules give what is not a
// number.
UnaryRule unary_rule(std::string_view function);
BinaryRule binary_rule(std::string_view function);

// The operators +, -, *, /, ^ and the comparisons, whose derivatives are zero.
SecondOrder operator_rule(BinaryOperator operation, double a, double b);

}  // namespace lamella::language
