#include <cmath>

#include "support/trial.h"

namespace lamella::trial {
namespace {

TEST(Average, TellsEachRoundLikeEvolver) {
  Trial trial("cube.fe");
  trial.session().set_quiet(false);
  EXPECT_EQ(trial.out("V"), "Vertex averaging done.\n");
  EXPECT_EQ(trial.out("vertex_average 2"), "Vertex averaging done.\nVertex averaging done.\n");
  EXPECT_EQ(trial.out("average 0"), "");
}

// The cube's corners are cut in one round; its volume must not be.
TEST(Average, KeepsVolumes) {
  Trial trial("double_bubble.fe");
  trial.out("refine; relax 5; set vertex y y + 0.02*sin(id)");
  const double one = trial.number("body[1].volume");
  const double two = trial.number("body[2].volume");
  EXPECT_GT(std::abs(one - 1), 1e-6);
  trial.out("vc on; V 3");
  EXPECT_NEAR(trial.number("body[1].volume"), one, 1e-12);
  EXPECT_NEAR(trial.number("body[2].volume"), two, 1e-12);
  EXPECT_EQ(trial.number("body[1].target"), 1);
  trial.out("undo; vc off; V 3");
  EXPECT_GT(std::abs(trial.number("body[1].volume") - one), 1e-9);
}

TEST(Average, EvensTheMesh) {
  Trial trial("catenoid.fe");
  trial.out("refine 2; set vertex z z + 0.08*sin(9*id) where not fixed");
  const double before = trial.number("max(facet, area) / min(facet, area)");
  trial.out("V 20");
  EXPECT_LT(trial.number("max(facet, area) / min(facet, area)"), 0.5 * before);
}

TEST(Average, LeavesFixedVerticesAndCorners) {
  Trial trial("wire_cube.fe");
  trial.out("refine 2; relax");
  const Folder folder;
  const std::string held = "list vertices where fixed";
  const std::string before = trial.out(held);
  trial.out("V 3");
  EXPECT_EQ(trial.out(held), before);
}

TEST(Average, Refuses) {
  Trial trial("cube.fe");
  EXPECT_TRUE(contains(trial.failure("V -1"), "test:1:3: error: times must be at least 0, not -1"));
  EXPECT_TRUE(contains(trial.failure("V 1.5"), "test:1:3: error: times must be a whole number, not 1.5"));
  EXPECT_TRUE(contains(trial.failure("average all"), "average does not take \"all\" here"));
  EXPECT_TRUE(contains(Trial().failure("V"), "there is no film to average"));
}

}  // namespace
}  // namespace lamella::trial
