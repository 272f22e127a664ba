#include "support/trial.h"

namespace lamella::trial {
namespace {

// Twelve triangles from the wires to the centre of an octahedron: area 6 for corners at distance 1. The least
// has 4 sqrt 2.
constexpr const char* octahedron_cone = R"(
vertices
1 1 0 0 fixed
2 -1 0 0 fixed
3 0 1 0 fixed
4 0 -1 0 fixed
5 0 0 1 fixed
6 0 0 -1 fixed
7 0 0 0
edges
1 1 3 fixed
2 3 2 fixed
3 2 4 fixed
4 4 1 fixed
5 1 5 fixed
6 3 5 fixed
7 2 5 fixed
8 4 5 fixed
9 1 6 fixed
10 3 6 fixed
11 2 6 fixed
12 4 6 fixed
21 7 1
22 7 2
23 7 3
24 7 4
25 7 5
26 7 6
faces
1 21 1 -23
2 23 2 -22
3 22 3 -24
4 24 4 -21
5 21 5 -25
6 23 6 -25
7 22 7 -25
8 24 8 -25
9 21 9 -26
10 23 10 -26
11 22 11 -26
12 24 12 -26
)";

TEST(Pop, TheOctahedralConeFallsToTheMinimalFilm) {
  const Folder folder;
  const std::string file = folder.write("octahedron.fe", octahedron_cone);
  Trial trial;
  trial.out("load \"" + file + "\"");
  EXPECT_NEAR(trial.number("total_area"), 6, 1e-12);
  trial.out("pop vertex[7]");
  EXPECT_GE(trial.number("vertex_pop_count"), 1);
  trial.out("check; o; check");
  EXPECT_EQ(trial.number("vertex_count"), 11);
  trial.out("relax; refine; relax; check");
  EXPECT_NEAR(trial.number("total_area"), 4 * std::sqrt(2.0), 1e-6);
}

TEST(Pop, LegalFilmsAreLeftAlone) {
  Trial trial("wire_cube.fe");
  trial.session().set_quiet(false);
  EXPECT_EQ(trial.out("o"), "Vertices popped: 0\n");
  EXPECT_EQ(trial.out("O"), "Edges popped: 0\n");
  EXPECT_EQ(trial.out("pop vertices"), "");
  EXPECT_EQ(trial.number("pop_count"), 0);
}

TEST(Pop, TakesVerticesAndEdges) {
  Trial trial("cube.fe");
  EXPECT_TRUE(contains(trial.failure("pop facets"), "burst facet[5]"));
}

}  // namespace
}  // namespace lamella::trial
