#include "support/trial.h"

namespace lamella::trial {
namespace {

TEST(Zoom, KeepsWhatIsNear) {
  Trial trial("catenoid.fe");
  trial.out("r");
  const double before = trial.number("facet_count");
  trial.out("zoom 1 0.5");
  EXPECT_LT(trial.number("facet_count"), before);
  EXPECT_GT(trial.number("facet_count"), 0);
  EXPECT_LE(trial.number("max(vertex, (x-vertex[1].x)^2 + (y-vertex[1].y)^2 + (z-vertex[1].z)^2)"),
            0.25 + 1e-12);
  EXPECT_EQ(trial.number("count(edge where valence == 1 and not fixed)"), 0);
  EXPECT_EQ(trial.out("check; print check_count"), "0\n");
}

TEST(Zoom, Refuses) {
  EXPECT_TRUE(contains(Trial("cube.fe").failure("zoom 1 1"), "there are bodies, which cannot be cut"));
  EXPECT_TRUE(contains(Trial("catenoid.fe").failure("Z 9999 1"), "there is no vertex 9999"));
  EXPECT_TRUE(contains(Trial("catenoid.fe").failure("Z"), "Z needs vertex"));
}

}  // namespace
}  // namespace lamella::trial
