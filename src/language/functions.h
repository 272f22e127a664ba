// The functions and constants that expressions know by name.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "language/expression.h"

namespace lamella::language {

struct Function {
  std::string_view name;
  std::size_t arguments = 1;
  // Given as many numbers as it takes. Throws text::Error without a place outside its domain.
  double (*value)(std::span<const double>) = nullptr;
  std::string_view summary;
};

std::span<const Function> functions();
// Null if there is none. Case does not matter.
const Function* find_function(std::string_view name);

struct NamedNumber {
  std::string_view name;
  double value = 0;
};

// pi, e and the colors. Names that a scene defines go before these.
std::span<const NamedNumber> named_numbers();
std::optional<double> named_number(std::string_view name);

// What the operators do; throws text::Error without a place, e.g. for a division by zero.
double apply(BinaryOperator operation, double a, double b);
std::string_view symbol_of(BinaryOperator operation);

}  // namespace lamella::language
