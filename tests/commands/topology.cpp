#include "support/trial.h"

namespace lamella::trial {
namespace {

TEST(Topology, IsOnUntilTurnedOff) {
  Trial trial("cube.fe");
  EXPECT_EQ(trial.out("topology"), "topology on\n");
  EXPECT_EQ(trial.out("topology off; topology"), "topology off\n");
  EXPECT_EQ(trial.out("topology on; topology"), "topology on\n");
  EXPECT_TRUE(contains(trial.failure("topology on off"), "on, or off?"));
}

// A film between rings that are too far apart closes its neck, and two discs are left.
TEST(Topology, ACatenoidTooLongBecomesTwoDiscs) {
  Trial trial("catenoid_on_rings.fe");
  trial.out("half := 0.75; recalc; refine 3; damping := 1; evolve 300; check");
  const Folder folder;
  EXPECT_EQ(trial.number("count(vertex where abs(z) < 0.3)"), 0);
  trial.out("evolve 300; check");
  EXPECT_NEAR(trial.number("total_area"), 2 * M_PI * std::pow(std::cosh(0.75), 2), 0.3);
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
