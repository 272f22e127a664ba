#include "support/trial.h"

namespace lamella::trial {
namespace {

TEST(PopTriToEdge, TakesFacets) {
  Trial trial("cube.fe");
  EXPECT_TRUE(contains(trial.failure("pop_tri_to_edge edges"), "only a facet"));
}

// None of the facets of a cube has three borders.
TEST(PopTriToEdge, LeavesOthers) {
  Trial trial("cube.fe");
  trial.out("pop_tri_to_edge facets");
  EXPECT_EQ(trial.number("pop_tri_to_edge_count"), 0);
  EXPECT_EQ(trial.number("facet_count"), 24);
}

}  // namespace
}  // namespace lamella::trial
