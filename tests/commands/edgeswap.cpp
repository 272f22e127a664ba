#include "support/trial.h"

namespace lamella::trial {
namespace {

TEST(Edgeswap, FlipsWhatItIsTold) {
  Trial trial("cube.fe");
  trial.session().set_quiet(false);
  EXPECT_EQ(trial.number("edge[13].vertex[1].id"), 1);
  EXPECT_EQ(trial.out("edgeswap edge[1]"), "Edges swapped: 1\n");
  EXPECT_EQ(trial.number("edgeswap_count"), 1);
  EXPECT_NEAR(trial.number("edge[1].length"), 0.70710678118654757, 1e-14);
  EXPECT_EQ(trial.out("check"), "Checks completed.\n");
  EXPECT_EQ(trial.out("fix edge[2]; edgeswap edge[2]"), "fixed: 1\n");
  EXPECT_EQ(trial.number("edgeswap_count"), 0);
}

TEST(Edgeswap, Refuses) {
  EXPECT_TRUE(contains(Trial("cube.fe").failure("edgeswap facet[1]"), "only edges can be swapped"));
}

}  // namespace
}  // namespace lamella::trial
