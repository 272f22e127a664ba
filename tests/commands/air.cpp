#include <cmath>

#include "support/trial.h"

namespace lamella::trial {
namespace {

// A fan that pushes everything evenly moves all of the air, and the air a bubble.
TEST(Air, BlowsABubbleAlong) {
  Trial trial("cube.fe");
  trial.out("refine 2; relax; air cells 8 fan (1, 0, 0)");
  trial.out("evolve 1; evolve 100 dt 0.005");
  EXPECT_GT(trial.number("momentum_x"), 0.01);
  EXPECT_NEAR(trial.number("momentum_y"), 0, 1e-6);
  EXPECT_TRUE(contains(trial.out("air"), "fan (1, 0, 0)\nfastest 0.5"));
}

TEST(Air, CostsNothingToAFilmThatItLeavesAlone) {
  Trial with("cube.fe");
  Trial without("cube.fe");
  for (Trial* trial : {&with, &without}) trial->out("refine 2; relax; set vertices velocity[1] 0.1*z");
  with.out("air cells 8 pressure 0");
  for (Trial* trial : {&with, &without}) trial->out("evolve 20 dt 0.005");
  EXPECT_EQ(with.number("kinetic_energy"), without.number("kinetic_energy"));
}

// What a file does not keep is told when it is written.
TEST(Air, ThatHasFlowedIsNotSavedInSilence) {
  Trial trial("cube.fe");
  const Folder folder;
  const std::string save = "save \"" + (folder / "air.fe") + "\"";
  trial.out("air cells 8 fan (1, 0, 0)");
  EXPECT_FALSE(contains(trial.run(save).messages, "still air"));
  trial.out("evolve 2");
  EXPECT_TRUE(contains(trial.run(save).messages, "still air"));
}

TEST(Air, IsPrintedTakenBackSavedAndTurnedOff) {
  Trial trial("cube.fe");
  const Folder folder;
  EXPECT_EQ(trial.out("air"), "air off\n");
  trial.out("air cells 16 from (-1, -1, -1) to (2, 2, 3) jet (0, 0, z<0) viscosity 0.01 pressure 2");
  const std::string said = trial.out("air");
  EXPECT_TRUE(
      contains(said, "air cells 16 from (-1, -1, -1) to (2, 2, 3) viscosity 0.01 pressure 2\njet (0, 0, z"));
  trial.out("save \"" + (folder / "a.fe") + "\"");
  EXPECT_EQ(Trial().out("load \"" + (folder / "a.fe") + "\"; air"), said);
  trial.out("undo");
  EXPECT_EQ(trial.out("air"), "air off\n");
  trial.out("redo; air off");
  EXPECT_EQ(trial.out("air"), "air off\n");
}

TEST(Air, Refuses) {
  Trial trial("cube.fe");
  EXPECT_TRUE(contains(trial.failure("air from (3, 0, 0)"), "the box of air is empty"));
  EXPECT_TRUE(contains(trial.failure("air cells 2"), "at least 4"));
  EXPECT_TRUE(contains(trial.failure("air off cells 8"), "air, or off?"));
}

}  // namespace
}  // namespace lamella::trial
