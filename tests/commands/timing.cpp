#include "support/trial.h"

namespace lamella::trial {
namespace {

TEST(Timing, SplitsAStep) {
  Trial trial("cube.fe");
  EXPECT_TRUE(contains(trial.failure("timing"), "no step has been timed yet"));
  trial.out("refine 3; relax; kick (0.1*z, 0, 0); evolve 50");
  const std::string table = trial.out("timing");
  for (const char* part : {"forces", "volumes", "surgery", "other", "step", "ns a facet"})
    EXPECT_TRUE(contains(table, part));
  EXPECT_EQ(trial.number("step_facets"), trial.number("facet_count"));
  EXPECT_GT(trial.number("step_forces_ms"), 0);
  EXPECT_NEAR(trial.number("step_forces_ms + step_volumes_ms + step_surgery_ms + step_other_ms"),
              trial.number("step_ms"), 1e-9);
}

// Without bodies no time goes into volumes but that of looking for them.
TEST(Timing, KnowsThatFilmsWithoutBodiesHaveNoVolumes) {
  Trial trial("wire_cube.fe");
  trial.out("refine 3; evolve 50");
  EXPECT_LT(trial.number("step_surgery_ms"), trial.number("step_ms"));
  EXPECT_GT(trial.number("step_facets"), 0);
}

}  // namespace
}  // namespace lamella::trial
