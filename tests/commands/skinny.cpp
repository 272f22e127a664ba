#include "support/trial.h"

namespace lamella::trial {
namespace {

// Counts as in Surface Evolver.
TEST(Skinny, HalvesLongestEdgesOnce) {
  Trial trial("cube.fe");
  trial.session().set_quiet(false);
  trial.out("r");
  EXPECT_EQ(trial.out("K 0.7"), "New edges: 0\n");
  EXPECT_EQ(trial.out("K 0.8"), "New edges: 48\n");
  EXPECT_EQ(trial.out("skinny 0.9"), "New edges: 96\n");
  EXPECT_EQ(trial.out("c"), "Vertices: 194  Edges: 576  Facets: 384  Bodies: 1  Facetedges: 1152\n");
  EXPECT_EQ(trial.number("edge_refine_count"), 96);
}

TEST(Skinny, Refuses) {
  EXPECT_TRUE(contains(Trial("cube.fe").failure("K"), "K needs angle"));
}

}  // namespace
}  // namespace lamella::trial
