#include <cmath>

#include "support/trial.h"

namespace lamella::trial {
namespace {

// A film that falls as a whole gains momentum as fast as its weight says, and energy as much as work is done.
TEST(Force, PullsTheWholeFilm) {
  Trial trial("cube.fe");
  trial.out("refine 2; relax; force (0, 0, -0.5)");
  trial.out("evolve 60 dt 0.005");
  EXPECT_NEAR(trial.number("total_time"), 0.3, 1e-12);
  const double mass = trial.number("sum(vertices, mass)");
  EXPECT_NEAR(trial.number("momentum_z") / mass, -0.15, 1e-12);
  EXPECT_NEAR(trial.number("momentum_x"), 0, 1e-12);
  EXPECT_NEAR(trial.number("outer_work"), 0.5 * mass * 0.15 * 0.15, 1e-10);
}

TEST(Force, KnowsVelocityTimeAndVariables) {
  Trial trial("cube.fe");
  trial.out("k := 2");
  trial.out("refine 2; relax; set vertices velocity[1] 1; force (-k*vx, total_time*0, 0)");
  trial.out("evolve 100 dt 0.005");
  const double speed = trial.number("momentum_x") / trial.number("sum(vertices, mass)");
  EXPECT_NEAR(speed, std::pow(1 - 2 * 0.005, 100), 1e-9);
}

TEST(Force, IsPrintedTakenBackAndTurnedOff) {
  Trial trial("cube.fe");
  EXPECT_EQ(trial.out("force"), "force off\n");
  trial.out("force (x, -y, 0.5)");
  EXPECT_EQ(trial.out("force"), "force (x, -y, 0.5)\n");
  trial.out("undo");
  EXPECT_EQ(trial.out("force"), "force off\n");
  trial.out("redo; force off");
  EXPECT_EQ(trial.out("force"), "force off\n");
}

TEST(Force, IsSavedWithTheWindAndTheirVariables) {
  Trial trial("cube.fe");
  const Folder folder;
  const std::string file = folder / "saved.fe";
  trial.out("k := 2");
  trial.out("force (x, -k*vy, sin(total_time)); wind (0, k, nx) pressure 3; save \"" + file + "\"");
  Trial other;
  other.out("load \"" + file + "\"");
  EXPECT_EQ(other.out("force"), trial.out("force"));
  EXPECT_EQ(other.out("wind"), trial.out("wind"));
  EXPECT_EQ(other.number("k"), 2);
  const std::string wrong =
      folder.write("wrong.fe", "parameter lamella_force = \"0, 0\"\n" + file_content(file));
  EXPECT_TRUE(contains(other.failure("load \"" + wrong + "\""), "is three formulas"));
}

TEST(Force, Refuses) {
  Trial trial("cube.fe");
  EXPECT_TRUE(contains(trial.failure("force (0, 0)"), "expected \",\", found \")\""));
  EXPECT_TRUE(contains(trial.failure("force (0, 0, nothing)"), "\"nothing\" is not defined"));
  trial.out("force (0, 0, 1/(z-z))");
  EXPECT_TRUE(contains(trial.failure("evolve 1"), "no longer finite"));
}

}  // namespace
}  // namespace lamella::trial
