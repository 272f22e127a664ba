#include "support/trial.h"

namespace lamella::trial {
namespace {

TEST(Topology, IsOnUntilTurnedOff) {
  Trial trial("cube.fe");
  EXPECT_EQ(trial.out("topology"), "topology on\n");
  EXPECT_EQ(trial.out("topology off; topology"), "topology off\n");
  EXPECT_EQ(trial.out("topology on; topology"), "topology on\n");
  EXPECT_EQ(trial.out("topology energy=lost; topology"), "topology on energy=lost\n");
  EXPECT_EQ(trial.out("topology energy=kept; topology"), "topology on\n");
  EXPECT_TRUE(contains(trial.failure("topology on off"), "on, or off?"));
}

// The rings of a film are drawn apart beyond the last catenoid: its neck closes, and two discs are left.
TEST(Topology, ANeckPinches) {
  Trial trial("rings_apart.fe");
  const Folder folder;
  trial.out("topology on; refine 3; relax; damping := 1; log events \"" + folder / "events.csv" + "\"");
  trial.out("evolve 350; check");
  EXPECT_TRUE(contains(file_content(folder / "events.csv"), ",pinch,"));
  EXPECT_EQ(trial.number("count(vertex where abs(z) < 0.1)"), 0);
  EXPECT_NEAR(trial.number("total_area"), M_PI / 2, 0.05);
}

// Drawn apart slowly, the film gives way where the last catenoid does, at half a distance of 0.3314: it takes
// a while to collapse, and the rings have gone on a little.
TEST(Topology, ANeckPinchesWhereTheCatenoidEnds) {
  Trial trial("rings_apart.fe");
  const Folder folder;
  trial.out("speed := 0.002; start := 0.328; refine 3; relax; damping := 0.2");
  trial.out("pinched := 0; on pinch { if pinched == 0 then pinched := total_time }");
  trial.out("while pinched == 0 && total_time < 20 do evolve 100");
  const double half = 0.328 + 0.002 * trial.number("pinched");
  EXPECT_GT(half, 0.3314);
  EXPECT_LT(half, 0.34);
}

// Two bubbles fly toward each other, touch, and share a film.
TEST(Topology, BubblesMerge) {
  Trial trial("two_bubbles.fe");
  trial.out("topology on; throw; evolve 30; check");
  EXPECT_GT(trial.number("count(facet where frontbody != 0 and backbody != 0)"), 20);
  trial.out("evolve 100; check");
  EXPECT_EQ(trial.number("body_count"), 2);
  EXPECT_NEAR(trial.number("body[1].volume"), 1, 1e-9);
  EXPECT_LT(trial.number("total_area"), 9.3);
}

TEST(Topology, OffTheFilmKeepsItsMesh) {
  Trial trial("double_bubble.fe");
  trial.out("refine 2; relax");
  const double facets = trial.number("facet_count");
  trial.out("topology off; set vertex velocity[3] z; evolve 50");
  EXPECT_EQ(trial.number("facet_count"), facets);
}

// A film at rest is not touched at all.
TEST(Topology, AFilmAtRestIsLeftAlone) {
  Trial trial("double_bubble.fe");
  trial.out("refine 3; relax");
  const auto before = trial.session().scene().film.connectivity_revision();
  trial.out("evolve 20; check");
  EXPECT_EQ(trial.session().scene().film.connectivity_revision(), before);
}

}  // namespace
}  // namespace lamella::trial
