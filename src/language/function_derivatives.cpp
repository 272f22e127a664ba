#include "language/function_derivatives.h"

#include <array>
#include <cmath>

namespace lamella::language {

namespace {

struct NamedUnary {
  std::string_view name;
  UnaryRule rule;
};

UnaryDerivatives square_root(double x) {
  const double r = std::sqrt(x);
  return {r, 0.5 / r, -0.25 / (r * x)};
}

UnaryDerivatives logarithm(double x) {
  return {std::log(x), 1 / x, -1 / (x * x)};
}

UnaryDerivatives tangent(double x) {
  const double t = std::tan(x);
  return {t, 1 + t * t, 2 * t * (1 + t * t)};
}

UnaryDerivatives arcsine(double x) {
  const double c = 1 / std::sqrt(1 - x * x);
  return {std::asin(x), c, x * c * c * c};
}

UnaryDerivatives arccosine(double x) {
  const double c = 1 / std::sqrt(1 - x * x);
  return {std::acos(x), -c, -x * c * c * c};
}

UnaryDerivatives hyperbolic_tangent(double x) {
  const double t = std::tanh(x);
  return {t, 1 - t * t, -2 * t * (1 - t * t)};
}

constexpr std::array<NamedUnary, 20> unary_rules{{
    {"abs",
     [](double x) -> UnaryDerivatives {
       return {std::abs(x), x < 0 ? -1.0 : 1.0, 0};
     }},
    {"sqr",
     [](double x) -> UnaryDerivatives {
       return {x * x, 2 * x, 2};
     }},
    {"sqrt", square_root},
    {"exp",
     [](double x) -> UnaryDerivatives {
       return {std::exp(x), std::exp(x), std::exp(x)};
     }},
    {"log", logarithm},
    {"ln", logarithm},
    {"sin",
     [](double x) -> UnaryDerivatives {
       return {std::sin(x), std::cos(x), -std::sin(x)};
     }},
    {"cos",
     [](double x) -> UnaryDerivatives {
       return {std::cos(x), -std::sin(x), -std::cos(x)};
     }},
    {"tan", tangent},
    {"asin", arcsine},
    {"acos", arccosine},
    {"atan",
     [](double x) -> UnaryDerivatives {
       const double d = 1 / (1 + x * x);
       return {std::atan(x), d, -2 * x * d * d};
     }},
    {"sinh",
     [](double x) -> UnaryDerivatives {
       return {std::sinh(x), std::cosh(x), std::sinh(x)};
     }},
    {"cosh",
     [](double x) -> UnaryDerivatives {
       return {std::cosh(x), std::sinh(x), std::cosh(x)};
     }},
    {"tanh", hyperbolic_tangent},
    {"asinh",
     [](double x) -> UnaryDerivatives {
       const double c = 1 / std::sqrt(1 + x * x);
       return {std::asinh(x), c, -x * c * c * c};
     }},
    {"acosh",
     [](double x) -> UnaryDerivatives {
       const double c = 1 / std::sqrt(x * x - 1);
       return {std::acosh(x), c, -x * c * c * c};
     }},
    {"atanh",
     [](double x) -> UnaryDerivatives {
       const double d = 1 / (1 - x * x);
       return {std::atanh(x), d, 2 * x * d * d};
     }},
    {"ceil",
     [](double x) -> UnaryDerivatives {
       return {std::ceil(x), 0, 0};
     }},
    {"floor",
     [](double x) -> UnaryDerivatives {
       return {std::floor(x), 0, 0};
     }},
}};

// a^b. For a whole number b a may be negative, and a derivative by b is not needed where b is constant.
SecondOrder slopes_of_power(double a, double b) {
  SecondOrder d;
  d.f = std::pow(a, b);
  d.a = b == 0 ? 0 : b * std::pow(a, b - 1);
  d.aa = b == 0 || b == 1 ? 0 : b * (b - 1) * std::pow(a, b - 2);
  if (a > 0) {
    const double l = std::log(a);
    d.b = d.f * l;
    d.bb = d.f * l * l;
    d.ab = std::pow(a, b - 1) * (1 + b * l);
  }
  return d;
}

SecondOrder quotient(double a, double b) {
  const double q = 1 / b;
  return {a * q, q, -a * q * q, 0, -q * q, 2 * a * q * q * q};
}

SecondOrder arctangent_of_two(double y, double x) {
  const double r = x * x + y * y;
  const double u = x / r;
  const double v = -y / r;
  return {std::atan2(y, x), u, v, 2 * u * v, (y * y - x * x) / (r * r), -2 * u * v};
}

SecondOrder chosen(bool first, double a, double b) {
  SecondOrder d;
  d.f = first ? a : b;
  (first ? d.a : d.b) = 1;
  return d;
}

SecondOrder flat(double f) {
  return {f, 0, 0, 0, 0, 0};
}

}  // namespace

UnaryRule unary_rule(std::string_view function) {
  for (const NamedUnary& named : unary_rules) {
    if (named.name == function) return named.rule;
  }
  return nullptr;
}

BinaryRule binary_rule(std::string_view function) {
  if (function == "pow") return slopes_of_power;
  if (function == "atan2") return arctangent_of_two;
  if (function == "minimum" || function == "min")
    return [](double a, double b) { return chosen(a <= b, a, b); };
  if (function == "maximum" || function == "max")
    return [](double a, double b) { return chosen(a >= b, a, b); };
  return nullptr;
}

SecondOrder operator_rule(BinaryOperator operation, double a, double b) {
  const auto truth = [](bool t) { return flat(t ? 1 : 0); };
  switch (operation) {
    case BinaryOperator::add:
      return {a + b, 1, 1, 0, 0, 0};
    case BinaryOperator::subtract:
    case BinaryOperator::equate:
      return {a - b, 1, -1, 0, 0, 0};
    case BinaryOperator::multiply:
      return {a * b, b, a, 0, 1, 0};
    case BinaryOperator::divide:
      return quotient(a, b);
    case BinaryOperator::power:
      return slopes_of_power(a, b);
    case BinaryOperator::modulus:
      return {a - std::floor(a / b) * b, 1, -std::floor(a / b), 0, 0, 0};
    case BinaryOperator::integer_modulus: {
      const double m = std::floor(a);
      const double n = std::floor(b);
      return flat(m - std::floor(m / n) * n);
    }
    case BinaryOperator::integer_divide:
      return flat(std::trunc(std::trunc(a) / std::trunc(b)));
    case BinaryOperator::equal:
      return truth(a == b);
    case BinaryOperator::not_equal:
      return truth(a != b);
    case BinaryOperator::less:
      return truth(a < b);
    case BinaryOperator::greater:
      return truth(a > b);
    case BinaryOperator::less_equal:
      return truth(a <= b);
    case BinaryOperator::greater_equal:
      return truth(a >= b);
    case BinaryOperator::logical_and:
      return truth(a != 0 && b != 0);
    case BinaryOperator::logical_or:
      return truth(a != 0 || b != 0);
  }
  return flat(NAN);
}

}  // namespace lamella::language
