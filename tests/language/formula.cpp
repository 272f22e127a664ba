#include "language/formula.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "language/formula_scope.h"
#include "language/lexer.h"
#include "text/error.h"

namespace lamella::language {
namespace {

Formula compiled(const std::string& text, const Variables& variables = {},
                 const std::vector<std::string>& attributes = {}, FormulaKind kind = FormulaKind::space) {
  LexerStream tokens(Lexer(text::make_source("formula", text), LexerMode::datafile));
  Formula formula = parse_formula(tokens, kind, variables, attributes);
  formula.bind(variables);
  return formula;
}

double value(const Formula& formula, std::array<double, 3> x) {
  return formula.value({x, 0.25, {}});
}

TEST(Formula, HasTheValueOfItsExpression) {
  EXPECT_DOUBLE_EQ(value(compiled("x^2 + y^2 = 4"), {1, 2, 0}), 1);
  EXPECT_DOUBLE_EQ(value(compiled("x1*x2*x3"), {2, 3, 5}), 30);
  EXPECT_DOUBLE_EQ(value(compiled("z > 1 ? x : y"), {7, 8, 2}), 7);
  EXPECT_DOUBLE_EQ(value(compiled("z > 1 ? x : y"), {7, 8, 0}), 8);
  EXPECT_DOUBLE_EQ(value(compiled("-x^2"), {3, 0, 0}), -9);
  EXPECT_DOUBLE_EQ(value(compiled("2*total_time"), {0, 0, 0}), 0.5);
  EXPECT_DOUBLE_EQ(value(compiled("(!(x > 0)) + (y == 2 && z != 3)"), {-1, 2, 0}), 2);
}

TEST(Formula, BranchesNotTakenMayHaveNoValue) {
  const Formula f = compiled("x > 0 ? sqrt(x) : 0");
  EXPECT_EQ(value(f, {-1, 0, 0}), 0);
  const Jet jet = f.hessian({std::array{-1.0, 0.0, 0.0}, 0, {}});
  EXPECT_EQ(jet.gradient[0], 0);
  EXPECT_TRUE(std::isnan(value(compiled("sqrt(x)"), {-1, 0, 0})));
}

// Side by side or one by one, the numbers are the same.
TEST(Formula, LanesAgreeWithPoints) {
  for (const char* const text :
       {"x^2 + y^2 + z^2 = 9", "x*y - z/(1 + x^2)", "x^3 - 2*y^-2 + z**1.5", "sin(x)*atan2(y, z)",
        "x > y ? x^4 : max(y, z)", "total_time*x - (x > 0)", "7", "!(x - y) + sqrt(z)", "x^0 + y^1 - x^7"}) {
    SCOPED_TRACE(text);
    const Formula f = compiled(text);
    std::mt19937 random(3);
    std::uniform_real_distribution<double> number(0.1, 2);
    std::array<Lanes, 3> points;
    for (Lanes& axis : points)
      for (double& x : axis) x = number(random);
    const Lanes values = f.values(points, 0.25);
    const First<Lanes> firsts = f.gradients(points, 0.25);
    for (std::size_t i = 0; i < lane_count; ++i) {
      const std::array<double, 3> at{points[0][i], points[1][i], points[2][i]};
      const Jet jet = f.gradient({at, 0.25, {}});
      EXPECT_EQ(values[i], f.value({at, 0.25, {}}));
      EXPECT_EQ(firsts.value[i], values[i]);
      for (std::size_t k = 0; k < 3; ++k)
        EXPECT_NEAR(firsts.gradient[k][i], jet.gradient[k], 1e-14 * (1 + std::abs(jet.gradient[k])));
    }
  }
}

TEST(Formula, WholePowersAreExactWherePowersAre) {
  EXPECT_EQ(value(compiled("x^3"), {-3, 0, 0}), -27);
  EXPECT_EQ(value(compiled("x^-2"), {4, 0, 0}), 0.0625);
  EXPECT_EQ(value(compiled("x^0"), {0, 0, 0}), 1);
  EXPECT_EQ(compiled("x^0").gradient({std::array{0.0, 0.0, 0.0}, 0, {}}).gradient[0], 0);
  EXPECT_EQ(compiled("x^1").hessian({std::array{0.0, 0.0, 0.0}, 0, {}}).hessian[0], 0);
  EXPECT_EQ(compiled("x^2").hessian({std::array{0.0, 0.0, 0.0}, 0, {}}).hessian[0], 2);
}

TEST(Formula, ReadsVariablesAttributesAndParameters) {
  Variables variables;
  variables.set(variables.id("radius"), 3.0);
  Formula circle = compiled("radius*cos(p1)", variables, {}, FormulaKind::parameter);
  EXPECT_DOUBLE_EQ(circle.value({std::array{0.0, 0.0, 0.0}, 0, {}}), 3);
  EXPECT_TRUE(circle.depends_on_variables());
  EXPECT_FALSE(circle.depends_on_time());
  variables.set(variables.id("radius"), 5.0);
  circle.bind(variables);
  EXPECT_DOUBLE_EQ(circle.value({std::array{0.0, 0.0, 0.0}, 0, {}}), 5);
  const Formula lifted = compiled("z = zfix + x2", variables, {"zfix"});
  const std::array<double, 1> attribute{4};
  EXPECT_DOUBLE_EQ(lifted.value({std::array{0.0, 1.0, 7.0}, 0, attribute}), 2);
  EXPECT_TRUE(compiled("x - total_time").depends_on_time());
}

TEST(Formula, RefusesWhatHasNoPlaceInIt) {
  EXPECT_THROW(compiled("x + nonsense"), text::Error);
  EXPECT_THROW(compiled("x + \"a\""), text::Error);
}

// First and second derivatives of everything that may stand in a formula, against differences of fourth
// order.
class FormulaDerivatives : public testing::TestWithParam<const char*> {};

TEST_P(FormulaDerivatives, AgreeWithDifferences) {
  const Formula f = compiled(GetParam());
  std::mt19937 random(7);
  std::uniform_real_distribution<double> u(0.15, 0.85);
  for (int round = 0; round < 20; ++round) {
    std::array<double, 3> x{u(random), u(random), u(random)};
    const Jet jet = f.hessian({x, 0.25, {}});
    const Jet first = f.gradient({x, 0.25, {}});
    EXPECT_EQ(jet.value, value(f, x));
    const double h = 1e-3;
    const auto along = [&](std::size_t axis, auto&& g) {
      const auto at = [&](double step) {
        std::array<double, 3> y = x;
        y[axis] += step * h;
        return g(y);
      };
      return (8 * (at(1) - at(-1)) - (at(2) - at(-2))) / (12 * h);
    };
    std::size_t k = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_EQ(first.gradient[i], jet.gradient[i]);
      EXPECT_NEAR(jet.gradient[i], along(i, [&](const auto& y) { return value(f, y); }),
                  1e-7 * (1 + std::abs(jet.gradient[i])));
      for (std::size_t j = i; j < 3; ++j, ++k) {
        const double d = along(j, [&](const auto& y) { return f.gradient({y, 0.25, {}}).gradient[i]; });
        EXPECT_NEAR(jet.hessian[k], d, 1e-6 * (1 + std::abs(d)))
            << GetParam() << " by axes " << i << ", " << j;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, FormulaDerivatives,
                         testing::Values("x*y - z/y + 3", "x^3*y^2*z", "(x+y)^z", "x**-2 + 2^y",
                                         "-x*(y - -z)", "sqrt(x) + sqr(y)*z + abs(x - 2)",
                                         "exp(x*y) - log(z + x)", "sin(x)*cos(y)*tan(z)",
                                         "asin(x) + acos(y*z) + atan(x*z)", "sinh(x) + cosh(y*x) + tanh(z)",
                                         "asinh(x*y) + acosh(1 + z) + atanh(x/2)", "atan2(x, y) * z",
                                         "pow(x + 1, 2.5)", "minimum(x, 2)*y + maximum(z, -1)",
                                         "x > 2 ? y : x*x*z", "floor(x) + ceil(y) + z*z*z", "x % 2 * y"));

}  // namespace
}  // namespace lamella::language
