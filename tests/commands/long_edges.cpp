#include "support/trial.h"

namespace lamella::trial {
namespace {

// The cube's faces are cut at their centres: 12 edges of length 1 and 24 of 0.707.
TEST(LongEdges, HalvesWhatIsLonger) {
  Trial trial("cube.fe");
  trial.session().set_quiet(false);
  EXPECT_EQ(trial.out("l 1"), "New edges: 0\n");
  EXPECT_EQ(trial.out("l 0.8"), "New edges: 12\n");
  EXPECT_EQ(trial.number("edge_refine_count"), 12);
  EXPECT_EQ(trial.out("c; check"),
            "Vertices: 26  Edges: 72  Facets: 48  Bodies: 1  Facetedges: 144\nChecks completed.\n");
  EXPECT_EQ(trial.number("total_area"), 6);
  EXPECT_EQ(trial.number("body[1].volume"), 1);
}

// Each edge is tried once, as in Evolver: halves longer than the length wait for the next time.
TEST(LongEdges, OnceForEachEdge) {
  Trial trial("cube.fe");
  trial.session().set_quiet(false);
  EXPECT_EQ(trial.out("long_edges 0"), "New edges: 36\n");
  EXPECT_EQ(trial.number("vertex_count"), 50);
  trial.out("l 0.3; l 0.3; l 0.3; l 0.3");
  EXPECT_LE(trial.number("max(edge, length)"), 0.3);
}

// As many new edges as in Surface Evolver 2.70 after `r; g 5`.
TEST(LongEdges, HalvesWhatEvolverHalves) {
  const std::pair<const char*, double> counts[] = {
      {"cube.fe", 120}, {"double_bubble.fe", 120}, {"catenoid.fe", 0}, {"wire_cube.fe", 76}};
  for (const auto& [file, count] : counts) {
    Trial trial(file);
    trial.out("r; g 5; l 0.3");
    EXPECT_EQ(trial.number("edge_refine_count"), count) << file;
  }
}

TEST(LongEdges, Refuses) {
  Trial trial("cube.fe");
  EXPECT_TRUE(contains(trial.failure("l"), "test:1:1: error: l needs length"));
  EXPECT_TRUE(contains(trial.failure("l -1"), "length must be at least 0, not -1"));
  EXPECT_TRUE(contains(trial.failure("l 1 2"), "l does not take \"2\" here"));
  EXPECT_EQ(trial.number("edge_count"), 36);
  EXPECT_TRUE(contains(Trial().failure("l 1"), "there are no edges to halve"));
}

}  // namespace
}  // namespace lamella::trial
