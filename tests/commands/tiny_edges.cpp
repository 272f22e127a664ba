#include "support/trial.h"

namespace lamella::trial {
namespace {

// Surface Evolver: the same count, and the same film.
TEST(TinyEdges, CollapsesWhatIsShorter) {
  Trial trial("cube.fe");
  trial.session().set_quiet(false);
  trial.out("r");
  EXPECT_EQ(trial.out("t 0.3"), "Deleted edges: 0\n");
  EXPECT_EQ(trial.out("t 0.36"), "Deleted edges: 24\n");
  EXPECT_EQ(trial.out("c; check"),
            "Vertices: 14  Edges: 36  Facets: 24  Bodies: 1  Facetedges: 72\nChecks completed.\n");
  EXPECT_EQ(trial.number("edge_delete_count"), 24);
}

TEST(TinyEdges, Refuses) {
  Trial trial("cube.fe");
  EXPECT_TRUE(contains(trial.failure("t"), "t needs length (edges shorter than this collapse)"));
  EXPECT_TRUE(contains(Trial().failure("t 1"), "there is no film to weed"));
}

}  // namespace
}  // namespace lamella::trial
