#include "air/air_flow.h"

#include <cmath>

#include <gtest/gtest.h>

#include "language/formula_scope.h"
#include "language/lexer.h"

namespace lamella::air {
namespace {

scene::VectorFormula formula(const std::string& x, const std::string& y, const std::string& z) {
  const language::Variables none;
  scene::VectorFormula result;
  const std::array<std::string, 3> texts{x, y, z};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    language::LexerStream tokens(
        language::Lexer(text::make_source("test", texts[axis]), language::LexerMode::command));
    result.component[axis] = language::parse_formula(tokens, language::FormulaKind::space, none, {});
  }
  return result;
}

scene::Air box(int cells) {
  scene::Air air;
  air.cells = cells;
  air.from = {0, 0, 0};
  air.to = {1, 1, 1};
  return air;
}

// An even fan: the air goes faster and faster, everywhere alike.
TEST(AirFlow, AnEvenFanMovesItAsAWhole) {
  scene::Air air = box(8);
  air.fan = formula("0.5", "0", "-1");
  AirFlow flow(air, {});
  flow.advance(0.5);
  flow.store(air);
  const Vec3 v = flow.at({0.3, 0.99, 0.01});
  EXPECT_NEAR(v.x, 0.5 * air.time, 1e-12);
  EXPECT_NEAR(v.z, -air.time, 1e-12);
  EXPECT_GT(air.time, 0.4);
}

// What only compresses is taken out.
TEST(AirFlow, AForceWithAPotentialMovesNothing) {
  scene::Air air = box(16);
  air.fan = formula("cos(2*pi*x)", "0", "0");
  AirFlow flow(air, {});
  flow.advance(0.3);
  for (int i = 0; i < 10; ++i) EXPECT_LT(length(flow.at({0.1 * i, 0.3, 0.7})), 1e-6);
}

// A shear layer is divergence-free and carries only itself; viscosity damps it by exp(-nu k^2 t).
TEST(AirFlow, ViscosityDampsAShearLayer) {
  scene::Air air = box(16);
  air.viscosity = 0.05;
  const auto n = static_cast<std::size_t>(air.cells);
  std::vector<Vec3> start(n * n * n);
  for (std::size_t cell = 0; cell < start.size(); ++cell) {
    const double y = (static_cast<double>(cell / n % n) + 0.5) / 16;
    start[cell].x = 0.3 * std::sin(2 * M_PI * y);
  }
  air.velocity = std::make_shared<const std::vector<Vec3>>(start);
  AirFlow flow(air, {});
  flow.advance(0.2);
  flow.store(air);
  EXPECT_NEAR(flow.at({0.5, 0.21875, 0.5}).x,
              0.3 * std::sin(2 * M_PI * 0.21875) * std::exp(-0.05 * 4 * M_PI * M_PI * air.time), 1e-9);
}

// A vortex array of Taylor and Green is steady without viscosity, but for what interpolation smooths.
TEST(AirFlow, VorticesLast) {
  scene::Air air = box(32);
  std::vector<Vec3> start(32 * 32 * 32);
  for (std::size_t cell = 0; cell < start.size(); ++cell) {
    const double x = 2 * M_PI * (static_cast<double>(cell % 32) + 0.5) / 32;
    const double y = 2 * M_PI * (static_cast<double>(cell / 32 % 32) + 0.5) / 32;
    start[cell] = {std::sin(x) * std::cos(y), -std::cos(x) * std::sin(y), 0};
  }
  air.velocity = std::make_shared<const std::vector<Vec3>>(start);
  AirFlow flow(air, {});
  const Vec3 before = flow.at({0.25, 0, 0.5});
  flow.advance(0.2);
  const Vec3 after = flow.at({0.25, 0, 0.5});
  EXPECT_GT(after.x, 0.8 * before.x);
  EXPECT_LE(after.x, before.x + 1e-9);
  EXPECT_NEAR(after.y, before.y, 0.02);
}

TEST(AirFlow, JetsAreGivenAndTheBoxRepeats) {
  scene::Air air = box(16);
  air.jet = formula("2*(abs(y-0.5)<0.2)", "0", "0");
  AirFlow flow(air, {});
  flow.advance(0.3);
  EXPECT_GT(flow.at({0.9, 0.5, 0.5}).x, 1.5);
  EXPECT_NEAR(flow.at({0.9, 0.5, 0.5}).x, flow.at({-3.1, 5.5, 0.5}).x, 1e-12);
}

}  // namespace
}  // namespace lamella::air
