#include "support/trial.h"

namespace lamella::trial {
namespace {

TEST(Kick, AddsAVelocityByFormula) {
  Trial trial("cube.fe");
  trial.out("refine; kick (z, 0.5, -x*2); kick (0, -0.25, vx)");
  EXPECT_EQ(trial.number("sum(vertices, abs(velocity[1] - z))"), 0);
  EXPECT_EQ(trial.number("sum(vertices, abs(velocity[2] - 0.25))"), 0);
  EXPECT_NEAR(trial.number("sum(vertices, abs(velocity[3] + 2*x - z))"), 0, 1e-13);
  trial.out("kick off");
  EXPECT_EQ(trial.number("sum(vertices, velocity[1]^2 + velocity[2]^2)"), 0);
}

// Of two bodies, the vertices of one: the other's move only where both meet.
TEST(Kick, IsForOneBody) {
  Trial trial("double_bubble.fe");
  trial.out("refine 2; relax; kick (0, 0, 1) body 2");
  const double moved = trial.number("sum(vertices, velocity[3] > 0)");
  EXPECT_GT(moved, 0.3 * trial.number("vertex_count"));
  EXPECT_LT(moved, 0.75 * trial.number("vertex_count"));
  EXPECT_TRUE(contains(trial.failure("kick (0, 0, 1) body 7"), "there is no body 7"));
}

TEST(Kick, IsTheSameAtRandomForTheSameSeed) {
  Trial trial("cube.fe");
  trial.out("refine 2; kick random 0.1 seed 3");
  const double first = trial.number("sum(vertices, velocity[1]^2)");
  const double count = trial.number("vertex_count");
  EXPECT_NEAR(first / count, 0.01, 0.004);
  trial.out("kick off; kick random=0.1 seed=3");
  EXPECT_EQ(trial.number("sum(vertices, velocity[1]^2)"), first);
  trial.out("kick off; kick random=0.1 seed=4");
  EXPECT_NE(trial.number("sum(vertices, velocity[1]^2)"), first);
}

// A film that flies as a whole keeps doing so.
TEST(Kick, MovesTheFilm) {
  Trial trial("cube.fe");
  trial.out("refine 2; relax; kick (0.5, 0, 0); evolve 20 dt 0.005");
  EXPECT_NEAR(trial.number("momentum_x") / trial.number("sum(vertices, mass)"), 0.5, 1e-12);
}

TEST(Kick, Refuses) {
  Trial trial("cube.fe");
  EXPECT_TRUE(contains(trial.failure("kick"), "a velocity, a random one, or off?"));
  EXPECT_TRUE(contains(trial.failure("kick (1/(x-x), 0, 0)"), "is not finite"));
}

}  // namespace
}  // namespace lamella::trial
