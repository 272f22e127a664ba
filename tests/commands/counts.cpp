#include "support/trial.h"

namespace lamella::trial {
namespace {

// The row is Evolver's; it is asked for, so it is printed under -q too.
TEST(Counts, PrintsTheRow) {
  Trial trial("cube.fe");
  EXPECT_EQ(trial.out("c"), "Vertices: 14  Edges: 36  Facets: 24  Bodies: 1  Facetedges: 72\n");
  EXPECT_EQ(trial.out("counts > \"/dev/null\"; r; counts"),
            "Vertices: 50  Edges: 144  Facets: 96  Bodies: 1  Facetedges: 288\n");
  EXPECT_EQ(Trial().out("counts"), "Vertices: 0  Edges: 0  Facets: 0  Bodies: 0  Facetedges: 0\n");
  EXPECT_TRUE(contains(trial.failure("c x"), "c takes no arguments"));
}

}  // namespace
}  // namespace lamella::trial
