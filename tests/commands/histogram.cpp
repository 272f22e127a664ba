#include "support/trial.h"

namespace lamella::trial {
namespace {

TEST(Histogram, CountsInTwentyBins) {
  Trial trial("cube.fe");
  const std::string out = trial.out("histogram(edge, length)");
  EXPECT_TRUE(out.starts_with("   0.70711 -    0.72175     24\n")) << out;
  EXPECT_TRUE(out.ends_with("   0.98536 -          1     12\n")) << out;
  EXPECT_EQ(std::count(out.begin(), out.end(), '\n'), 20);
}

TEST(Histogram, OfSomeElements) {
  Trial trial("cube.fe");
  const std::string out = trial.out("ohistogram(facet ff where ff.id < 5, ff.area)");
  EXPECT_TRUE(out.starts_with("      0.25 -       0.25     4\n")) << out;
  EXPECT_TRUE(
      contains(trial.failure("histogram(edge where length > 5, length)"), "there are no such elements"));
  EXPECT_TRUE(contains(trial.failure("histogram(edge)"), "expected \",\""));
  EXPECT_TRUE(contains(trial.failure("histogram"), "histogram needs sample"));
}

}  // namespace
}  // namespace lamella::trial
