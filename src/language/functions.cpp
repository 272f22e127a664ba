#include "language/functions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "text/error.h"
#include "text/suggest.h"

namespace lamella::language {

namespace {

using Arguments = std::span<const double>;

[[noreturn]] void refuse(std::string_view function, double x, std::string_view why) {
  throw text::Error(fmt::format("{}({:.15g}) is not defined: {}", function, x, why));
}

double finite(std::string_view function, double x, double value) {
  if (!std::isfinite(value) && std::isfinite(x)) {
    throw text::Error(fmt::format("{}({:.15g}) is too large", function, x));
  }
  return value;
}

double square_root(Arguments a) {
  if (a[0] < 0) refuse("sqrt", a[0], "the argument is negative");
  return std::sqrt(a[0]);
}

double logarithm(Arguments a) {
  if (a[0] <= 0) refuse("log", a[0], "the argument must be positive");
  return std::log(a[0]);
}

// Rounding may carry a cosine a little past 1.
double clamped_unit(std::string_view function, double x) {
  constexpr double slack = 1e-12;
  if (std::abs(x) > 1 + slack) refuse(function, x, "the argument must lie between -1 and 1");
  return std::clamp(x, -1.0, 1.0);
}

double inverse_hyperbolic_cosine(Arguments a) {
  if (a[0] < 1) refuse("acosh", a[0], "the argument must be at least 1");
  return std::acosh(a[0]);
}

double inverse_hyperbolic_tangent(Arguments a) {
  if (std::abs(a[0]) >= 1) refuse("atanh", a[0], "the argument must lie between -1 and 1");
  return std::atanh(a[0]);
}

double power(double a, double b) {
  if (a < 0 && b != std::floor(b)) {
    throw text::Error(fmt::format("{:.15g} to the power {:.15g} is not a real number", a, b),
                      "a negative base takes whole exponents only");
  }
  if (a == 0 && b < 0) throw text::Error(fmt::format("division by zero: 0 to the power {:.15g}", b));
  const double value = std::pow(a, b);
  if (!std::isfinite(value) && std::isfinite(a) && std::isfinite(b)) {
    throw text::Error(fmt::format("{:.15g} to the power {:.15g} is too large", a, b));
  }
  return value;
}

// The modulus of an elliptic integral from its parameter.
double modulus_of(std::string_view function, double parameter) {
  if (!(parameter >= 0 && parameter < 1))
    refuse(function, parameter, "the parameter must be at least 0 and below 1");
  return std::sqrt(parameter);
}

double checked_divisor(double b) {
  if (b == 0) throw text::Error("division by zero");
  return b;
}

double modulus(double a, double b) {
  return a - std::floor(a / checked_divisor(b)) * b;
}

constexpr std::array<Function, 30> function_table = {{
    {"abs", 1, [](Arguments a) { return std::abs(a[0]); }, "absolute value"},
    {"sqr", 1, [](Arguments a) { return a[0] * a[0]; }, "square"},
    {"sqrt", 1, square_root, "square root"},
    {"exp", 1, [](Arguments a) { return finite("exp", a[0], std::exp(a[0])); }, "e to a power"},
    {"log", 1, logarithm, "natural logarithm"},
    {"ln", 1, logarithm, "natural logarithm"},
    {"sin", 1, [](Arguments a) { return std::sin(a[0]); }, "sine of an angle in radians"},
    {"cos", 1, [](Arguments a) { return std::cos(a[0]); }, "cosine of an angle in radians"},
    {"tan", 1, [](Arguments a) { return std::tan(a[0]); }, "tangent of an angle in radians"},
    {"asin", 1, [](Arguments a) { return std::asin(clamped_unit("asin", a[0])); }, "angle with this sine"},
    {"acos", 1, [](Arguments a) { return std::acos(clamped_unit("acos", a[0])); }, "angle with this cosine"},
    {"atan", 1, [](Arguments a) { return std::atan(a[0]); }, "angle with this tangent"},
    {"atan2", 2, [](Arguments a) { return std::atan2(a[0], a[1]); },
     "atan2(y,x): angle of the point (x,y), from -pi to pi"},
    {"sinh", 1, [](Arguments a) { return finite("sinh", a[0], std::sinh(a[0])); }, "hyperbolic sine"},
    {"cosh", 1, [](Arguments a) { return finite("cosh", a[0], std::cosh(a[0])); }, "hyperbolic cosine"},
    {"tanh", 1, [](Arguments a) { return std::tanh(a[0]); }, "hyperbolic tangent"},
    {"asinh", 1, [](Arguments a) { return std::asinh(a[0]); }, "inverse hyperbolic sine"},
    {"acosh", 1, inverse_hyperbolic_cosine, "inverse hyperbolic cosine"},
    {"atanh", 1, inverse_hyperbolic_tangent, "inverse hyperbolic tangent"},
    {"ceil", 1, [](Arguments a) { return std::ceil(a[0]); }, "next whole number above"},
    {"floor", 1, [](Arguments a) { return std::floor(a[0]); }, "next whole number below"},
    {"pow", 2, [](Arguments a) { return power(a[0], a[1]); }, "pow(x,y): x to the power y"},
    {"minimum", 2, [](Arguments a) { return std::min(a[0], a[1]); }, "the smaller of two numbers"},
    {"maximum", 2, [](Arguments a) { return std::max(a[0], a[1]); }, "the larger of two numbers"},
    {"min", 2, [](Arguments a) { return std::min(a[0], a[1]); },
     "the smaller of two numbers; the least over elements"},
    {"max", 2, [](Arguments a) { return std::max(a[0], a[1]); },
     "the larger of two numbers; the greatest over elements"},
    {"elliptick", 1, [](Arguments a) { return std::comp_ellint_1(modulus_of("ellipticK", a[0])); },
     "complete elliptic integral of the first kind, of the parameter m"},
    {"elliptice", 1, [](Arguments a) { return std::comp_ellint_2(modulus_of("ellipticE", a[0])); },
     "complete elliptic integral of the second kind, of the parameter m"},
    {"incompleteellipticf", 2,
     [](Arguments a) { return std::ellint_1(modulus_of("incompleteEllipticF", a[1]), a[0]); },
     "incompleteEllipticF(phi,m): elliptic integral of the first kind"},
    {"incompleteelliptice", 2,
     [](Arguments a) { return std::ellint_2(modulus_of("incompleteEllipticE", a[1]), a[0]); },
     "incompleteEllipticE(phi,m): elliptic integral of the second kind"},
}};

constexpr std::array<NamedNumber, 20> named_number_table = {{
    {"pi", std::numbers::pi},
    {"e", std::numbers::e},
    {"clear", -1},
    {"transparent", -1},
    {"black", 0},
    {"blue", 1},
    {"green", 2},
    {"cyan", 3},
    {"red", 4},
    {"magenta", 5},
    {"brown", 6},
    {"lightgray", 7},
    {"darkgray", 8},
    {"lightblue", 9},
    {"lightgreen", 10},
    {"lightcyan", 11},
    {"lightred", 12},
    {"lightmagenta", 13},
    {"yellow", 14},
    {"white", 15},
}};

}  // namespace

std::span<const Function> functions() {
  return function_table;
}

const Function* find_function(std::string_view name) {
  const std::string key = text::lower(name);
  const auto at = std::find_if(function_table.begin(), function_table.end(),
                               [&](const Function& function) { return function.name == key; });
  return at == function_table.end() ? nullptr : &*at;
}

std::span<const NamedNumber> named_numbers() {
  return named_number_table;
}

std::optional<double> named_number(std::string_view name) {
  const std::string key = text::lower(name);
  for (const NamedNumber& number : named_number_table) {
    if (number.name == key) return number.value;
  }
  return std::nullopt;
}

double apply(BinaryOperator operation, double a, double b) {
  switch (operation) {
    case BinaryOperator::add:
      return a + b;
    case BinaryOperator::subtract:
    case BinaryOperator::equate:
      return a - b;
    case BinaryOperator::multiply:
      return a * b;
    case BinaryOperator::divide:
      return a / checked_divisor(b);
    case BinaryOperator::modulus:
      return modulus(a, b);
    case BinaryOperator::integer_modulus:
      return modulus(std::floor(a), std::floor(b));
    case BinaryOperator::integer_divide:
      return std::trunc(std::trunc(a) / checked_divisor(std::trunc(b)));
    case BinaryOperator::power:
      return power(a, b);
    case BinaryOperator::equal:
      return a == b ? 1 : 0;
    case BinaryOperator::not_equal:
      return a != b ? 1 : 0;
    case BinaryOperator::less:
      return a < b ? 1 : 0;
    case BinaryOperator::greater:
      return a > b ? 1 : 0;
    case BinaryOperator::less_equal:
      return a <= b ? 1 : 0;
    case BinaryOperator::greater_equal:
      return a >= b ? 1 : 0;
    case BinaryOperator::logical_and:
      return a != 0 && b != 0 ? 1 : 0;
    case BinaryOperator::logical_or:
      return a != 0 || b != 0 ? 1 : 0;
  }
  return 0;
}

std::string_view symbol_of(BinaryOperator operation) {
  constexpr std::array<std::string_view, 17> symbols = {
      "+", "-", "*", "/", "%", "imod", "idiv", "^", "==", "!=", "<", ">", "<=", ">=", "&&", "||", "="};
  return symbols[static_cast<std::size_t>(operation)];
}

}  // namespace lamella::language
