// The gap energies of convex constraints and boundaries.
#include "energy/gap.h"

#include <cmath>

#include <gtest/gtest.h>

#include "scene/projection.h"
#include "support/formulas.h"

namespace lamella::energy {
namespace {

// The numbers are Surface Evolver's for the same edges.
TEST(Gap, OfAParabola) {
  const scene::LevelSet set = test::level_set("y = x^2");
  const GapEdge edge{&set.formula, film::Vertex(0U), film::Vertex(1U)};
  EXPECT_NEAR(gap_energy(edge, {0, 0, 0}, {1, 1, 0}, 0).value, 0.17055575786723098, 1e-15);
  EXPECT_NEAR(gap_energy(edge, {1, 1, 0}, {0, 0, 0}, 0).value, 0.17055575786723098, 1e-15);
  EXPECT_NEAR(gap_energy(edge, {-2, 4, 0}, {2, 4, 0}, 0).value, 2.58704666705421804, 1e-14);
  EXPECT_EQ(gap_energy(edge, {1, 1, 0}, {1, 1, 0}, 0).value, 0);
}

TEST(Gap, GradientAgreesWithDifferences) {
  const scene::LevelSet set = test::level_set("x^2 + 2*y^2 + 3*z^2 + x*y*z = 1");
  const GapEdge edge{&set.formula, film::Vertex(0U), film::Vertex(1U)};
  const std::array<Vec3, 2> ends{Vec3{0.9, 0.2, 0.1}, Vec3{0.4, 0.5, 0.3}};
  const EdgeGradient g = gap_energy(edge, ends[0], ends[1], 0);
  for (std::size_t end = 0; end < 2; ++end) {
    for (int axis = 0; axis < 3; ++axis) {
      const auto value = [&](double step) {
        std::array<Vec3, 2> moved = ends;
        moved[end][axis] += step;
        return gap_energy(edge, moved[0], moved[1], 0).value;
      };
      const double h = 1e-5;
      EXPECT_NEAR((end == 0 ? g.from : g.to)[axis], (value(h) - value(-h)) / (2 * h), 1e-9);
    }
  }
}

class BoundaryGap : public testing::Test {
 protected:
  BoundaryGap() {
    scene::Boundary& boundary = scene_.boundaries[1];
    boundary.convex = true;
    boundary.position = {test::formula("cos(p1)", language::FormulaKind::parameter),
                         test::formula("0.7*sin(p1)", language::FormulaKind::parameter),
                         test::formula("0.3*p1*p1", language::FormulaKind::parameter)};
    edge_ = BoundaryGapEdge{&boundary, film::Vertex(0U), film::Vertex(1U), 0.1, 0.9};
  }
  Vec3 at(double p) const { return scene::boundary_position(scene_, *edge_.boundary, {p, 0, 0}); }
  EdgeGradient gap(double a, double b) const { return boundary_gap_energy(scene_, edge_, at(a), at(b)); }

  scene::Scene scene_;
  BoundaryGapEdge edge_;
};

TEST_F(BoundaryGap, IsEvolvers) {
  EXPECT_NEAR(gap(0, 1).value, 0.22586811273227869 - 0.14801289216998273, 1e-14);
  EXPECT_NEAR(gap(1, 0).value, 0.22586811273227869 - 0.14801289216998273, 1e-14);
}

// Only motions along the boundary count.
TEST_F(BoundaryGap, GradientAgreesWithDifferences) {
  const double h = 1e-5;
  const double a = 0.2;
  const double b = 1.1;
  const EdgeGradient g = gap(a, b);
  EXPECT_NEAR(dot(g.from, (at(a + h) - at(a - h)) / (2 * h)),
              (gap(a + h, b).value - gap(a - h, b).value) / (2 * h), 1e-8);
  EXPECT_NEAR(dot(g.to, (at(b + h) - at(b - h)) / (2 * h)),
              (gap(a, b + h).value - gap(a, b - h).value) / (2 * h), 1e-8);
}

}  // namespace
}  // namespace lamella::energy
