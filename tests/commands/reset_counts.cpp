#include "support/trial.h"

namespace lamella::trial {
namespace {

TEST(ResetCounts, SetsThemToZero) {
  Trial trial("cube.fe");
  trial.out("r; delete edge[5]");
  EXPECT_EQ(trial.number("edge_delete_count"), 1);
  trial.out("reset_counts");
  EXPECT_EQ(trial.number("edge_delete_count"), 0);
  EXPECT_EQ(trial.number("edge_refine_count"), 0);
}

}  // namespace
}  // namespace lamella::trial
