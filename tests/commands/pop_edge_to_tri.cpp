#include "support/trial.h"

namespace lamella::trial {
namespace {

// A prism of wires, its film with an upright border in the middle (points 7 and 8).
constexpr const char* prism = R"(
vertices
1 1 0 -0.6 fixed
2 -0.5 0.866 -0.6 fixed
3 -0.5 -0.866 -0.6 fixed
4 1 0 0.6 fixed
5 -0.5 0.866 0.6 fixed
6 -0.5 -0.866 0.6 fixed
7 0 0 -0.2
8 0 0 0.2
edges
1 1 2 fixed
2 2 3 fixed
3 3 1 fixed
4 4 5 fixed
5 5 6 fixed
6 6 4 fixed
7 1 4 fixed
8 2 5 fixed
9 3 6 fixed
11 7 1
12 7 2
13 7 3
14 8 4
15 8 5
16 8 6
17 7 8
faces
1 11 1 -12
2 12 2 -13
3 13 3 -11
4 14 4 -15
5 15 5 -16
6 16 6 -14
7 11 7 -14 -17
8 12 8 -15 -17
9 13 9 -16 -17
)";

TEST(PopEdgeToTri, AndBack) {
  const Folder folder;
  Trial trial;
  trial.out("load \"" + folder.write("prism.fe", prism) + "\"");
  const double facets = trial.number("facet_count");
  trial.out("pop_edge_to_tri edge where valence == 3 and length < 0.5; check");
  EXPECT_EQ(trial.number("pop_edge_to_tri_count"), 1);
  EXPECT_GT(trial.number("facet_count"), facets);
  trial.out("pop_tri_to_edge facets; check");
  EXPECT_EQ(trial.number("pop_tri_to_edge_count"), 1);
  trial.out("relax");
  Trial other;
  other.out("load \"" + folder.write("again.fe", prism) + "\"; relax");
  EXPECT_NEAR(trial.number("total_area"), other.number("total_area"), 0.01);
}

TEST(PopEdgeToTri, TakesEdges) {
  Trial trial("cube.fe");
  EXPECT_TRUE(contains(trial.failure("pop_edge_to_tri facets"), "only an edge"));
}

}  // namespace
}  // namespace lamella::trial
