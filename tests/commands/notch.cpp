#include "support/trial.h"

namespace lamella::trial {
namespace {

// Counts as in Surface Evolver: every facet at a sharp edge is cut once.
TEST(Notch, CutsFacetsAtSharpEdges) {
  Trial trial("cube.fe");
  trial.session().set_quiet(false);
  trial.out("r; K 0.8; K 0.9");
  EXPECT_EQ(trial.out("n 2"), "Number of edges notched: 0\n");
  EXPECT_EQ(trial.out("n 1"), "Number of edges notched: 96\n");
  EXPECT_EQ(trial.out("c"), "Vertices: 290  Edges: 864  Facets: 576  Bodies: 1  Facetedges: 1728\n");
  EXPECT_EQ(trial.out("notch 1; c"),
            "Number of edges notched: 96\n"
            "Vertices: 386  Edges: 1152  Facets: 768  Bodies: 1  Facetedges: 2304\n");
  EXPECT_EQ(trial.number("notch_count"), 96);
  EXPECT_EQ(trial.number("body[1].volume"), 1);
}

TEST(Notch, Refuses) {
  EXPECT_TRUE(contains(Trial("cube.fe").failure("n"), "n needs angle"));
}

}  // namespace
}  // namespace lamella::trial
