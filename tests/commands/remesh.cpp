#include "film/check.h"
#include "film/intersections.h"
#include "support/trial.h"

namespace lamella::trial {
namespace {

TEST(Remesh, BringsEdgesToASize) {
  for (const char* const file : {"cube.fe", "double_bubble.fe", "catenoid_on_rings.fe", "wire_cube.fe"}) {
    Trial trial(file);
    trial.out("refine 2; relax");
    const double size = 1.5 * trial.number("avg(edge, length)");
    const double facets = trial.number("facet_count");
    const double area = trial.number("total_area");
    trial.out(fmt::format("remesh size {}; check", size));
    EXPECT_LT(trial.number("facet_count"), 0.75 * facets) << file;
    EXPECT_LT(trial.number("max(edge, length)"), 1.6 * size) << file;
    EXPECT_NEAR(trial.number("total_area"), area, 0.04 * area) << file;
    trial.out(fmt::format("remesh size {}; check", 0.4 * size));
    EXPECT_GT(trial.number("facet_count"), facets) << file;
    EXPECT_NEAR(trial.number("total_area"), area, 0.04 * area) << file;
  }
}

TEST(Remesh, SmallerWhereItCurves) {
  Trial trial("catenoid_on_rings.fe");
  trial.out("refine 3; relax");
  const double before = trial.number("min(edge, length)");
  trial.out("remesh curvature 5; check");
  EXPECT_LT(trial.number("min(edge, length)"), before);
}

TEST(Remesh, GoesByAFormula) {
  Trial trial("cube.fe");
  trial.out("refine 3; relax; remesh size 0.06 + 0.5*z^2; check");
  const double middle = trial.number("avg(edge ee where abs(ee.vertex[1].z) < 0.1, length)");
  EXPECT_NEAR(middle, 0.06, 0.02);
  EXPECT_GT(trial.number("avg(edge ee where ee.vertex[1].z > 0.5, length)"), 2 * middle);
  // Of facets: vertices take the smallest around.
  trial.out("remesh size facet (1 + valence)/40; check");
  EXPECT_NEAR(trial.number("avg(edge, length)"), 0.1, 0.03);
}

TEST(Remesh, IsFinerAtBordersAndPoints) {
  Trial trial("wire_cube.fe");
  trial.out("refine 2; relax; remesh size 0.3 borders 0.12 points 0.04; check");
  const double borders = trial.number("max(edge where valence >= 3, length)");
  EXPECT_LT(borders, 1.5 * 0.12);
  EXPECT_LT(trial.number("min(edge where valence >= 3, length)"), 1.5 * 0.04);
  EXPECT_GT(trial.number("max(edge, length)"), 0.2);
}

TEST(Remesh, RefusesSizesThatCannotBe) {
  Trial trial("cube.fe");
  EXPECT_TRUE(contains(trial.failure("remesh size 0.1*z"), "long, as is wanted at vertex"));
  EXPECT_TRUE(contains(trial.failure("remesh size 0"), "edges cannot be 0 long"));
  EXPECT_TRUE(contains(trial.failure("remesh size 1e-9"), "facets"));
  EXPECT_EQ(trial.number("facet_count"), 24);
}

TEST(Remesh, LeavesWhatIsWithinTheBand) {
  Trial trial("double_bubble.fe");
  trial.out("refine 3; relax; remesh");
  const auto revision = trial.session().scene().film.connectivity_revision();
  trial.out("remesh");
  EXPECT_EQ(trial.session().scene().film.connectivity_revision(), revision);
}

TEST(Remesh, NeedsAFilm) {
  Trial trial;
  EXPECT_TRUE(contains(trial.failure("remesh"), "there is no film to remesh"));
}

}  // namespace
}  // namespace lamella::trial
