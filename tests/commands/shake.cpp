#include "support/trial.h"

namespace lamella::trial {
namespace {

TEST(Shake, MovesWhatIsFree) {
  Trial trial("catenoid.fe");
  const std::string held = trial.out("list vertices where fixed");
  const double before = trial.number("total_area");
  trial.out("j 0.1");
  EXPECT_EQ(trial.out("list vertices where fixed"), held);
  EXPECT_GT(trial.number("total_area"), before + 0.01);
  EXPECT_EQ(trial.number("jiggle_temperature"), 0.1);
}

// The displacement is normal, with the temperature times the mean length of the edges as its deviation.
TEST(Shake, AsFarAsItIsTold) {
  Trial trial("cube.fe");
  trial.out("r 3; define vertex attribute old real; set vertex old x");
  const double mean = trial.number("avg(edge, length)");
  trial.out("j 0.2");
  const double deviation = trial.number("sqrt(avg(vertex, (x - old)^2))");
  EXPECT_NEAR(deviation / (0.2 * mean), 1, 0.1);
}

TEST(Shake, Repeats) {
  Trial one("cube.fe");
  Trial two("cube.fe");
  EXPECT_EQ(one.out("shake; list vertices"), two.out("j 0.05; list vertices"));
}

}  // namespace
}  // namespace lamella::trial
