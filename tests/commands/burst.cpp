#include "support/trial.h"

namespace lamella::trial {
namespace {

// The film between two bubbles breaks: one bubble of both volumes.
TEST(Burst, AFilmBetweenBubbles) {
  Trial trial("double_bubble.fe");
  trial.session().set_quiet(false);
  trial.out("refine 2");
  EXPECT_TRUE(contains(trial.out("burst facet[1]"), "time 0: burst at (0, 0, 0), bodies 1 2\n"));
  EXPECT_EQ(trial.number("burst_count"), 1);
  EXPECT_EQ(trial.number("body_count"), 1);
  EXPECT_NEAR(trial.number("body[1].target"), 2, 1e-12);
  trial.session().set_quiet(true);
  trial.out("check; relax; refine; relax");
  EXPECT_NEAR(trial.number("total_area"), std::cbrt(36 * M_PI * 4), 0.02);
}

TEST(Burst, ABodyOpensToTheOutside) {
  Trial trial("double_bubble.fe");
  trial.out("refine 2; burst body[2]; check");
  EXPECT_EQ(trial.number("body_count"), 1);
  EXPECT_EQ(trial.number("count(facet where frontbody == 2 or backbody == 2)"), 0);
  trial.out("relax");
  EXPECT_NEAR(trial.number("total_area"), std::cbrt(36 * M_PI), 0.05);
}

TEST(Burst, TheLastBubbleLeavesNothing) {
  Trial trial("cube.fe");
  trial.out("burst body[1]; check");
  EXPECT_EQ(trial.number("facet_count"), 0);
  EXPECT_EQ(trial.number("body_count"), 0);
}

TEST(Burst, TakesBodiesAndFacets) {
  Trial trial("cube.fe");
  EXPECT_TRUE(contains(trial.failure("burst edges"), "only bodies and films burst"));
}

}  // namespace
}  // namespace lamella::trial
