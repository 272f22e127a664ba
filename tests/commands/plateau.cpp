#include <cmath>

#include "support/trial.h"

namespace lamella::trial {
namespace {

constexpr const char* header = "degrees off Plateau's laws   angles          rms        worst\n";

// Three films on one edge, with right and one-and-a-half right angles between them: off by 30, 15 and 15.
constexpr const char* three_films = R"(vertices
1 0 0 0
2 0 0 1
3 1 0 0
4 0 1 0
5 -1 -1 0
edges
1 1 2
2 2 3
3 3 1
4 2 4
5 4 1
6 2 5
7 5 1
faces
1 1 2 3
2 1 4 5
3 1 6 7
)";

// A vertex in the middle of a regular tetrahedron, with films to its six edges.
constexpr const char* tetrahedron = R"(vertices
1 0 0 0
2 1 1 1 fixed
3 1 -1 -1 fixed
4 -1 1 -1 fixed
5 -1 -1 1 fixed
edges
1 1 2
2 1 3
3 1 4
4 1 5
5 2 3
6 2 4
7 2 5
8 3 4
9 3 5
10 4 5
faces
1 1 5 -2
2 1 6 -3
3 1 7 -4
4 2 8 -3
5 2 9 -4
6 3 10 -4
)";

TEST(Plateau, MeasuresTripleLines) {
  const Folder folder;
  Trial trial;
  trial.session().load(folder.write("film.fe", three_films));
  EXPECT_EQ(trial.out("plateau"), std::string(header) +
                                      "triple lines (120)                3      21.2132      30.0000\n"
                                      "quad points (109.4712)         none\n");
  EXPECT_NEAR(trial.number("triple_angle_rms"), std::sqrt(450.0), 1e-10);
  EXPECT_EQ(trial.number("quad_angle_rms"), 0);
  // A wire holds films at any angle.
  EXPECT_TRUE(
      contains(trial.out("fix vertices where id < 3; plateau"), "triple lines (120)             none\n"));
}

TEST(Plateau, MeasuresQuadPoints) {
  const Folder folder;
  Trial trial;
  trial.session().load(folder.write("film.fe", tetrahedron));
  EXPECT_EQ(trial.out("plateau"), std::string(header) +
                                      "triple lines (120)               12       0.0000       0.0000\n"
                                      "quad points (109.4712)            6       0.0000       0.0000\n");
  trial.out("set vertex[1] x 0.1");
  EXPECT_GT(trial.number("quad_angle_rms"), 1);
  EXPECT_GT(trial.number("triple_angle_rms"), 1);
}

// The kink of flat facets along a curved border shrinks with the mesh.
TEST(Plateau, ARelaxedDoubleBubbleKeepsThemBetterAndBetter) {
  Trial trial("double_bubble.fe");
  trial.out("refine 2; relax");
  const double coarse = trial.number("triple_angle_rms");
  trial.out("refine; relax");
  const double fine = trial.number("triple_angle_rms");
  EXPECT_LT(coarse, 2.2);
  EXPECT_LT(fine, 0.6 * coarse);
}

TEST(Plateau, PointsOutWhatIsUnstable) {
  const std::string printed = Trial("wire_cube.fe").out("plateau");
  EXPECT_TRUE(contains(printed, "triple lines (120)"));
  EXPECT_TRUE(contains(Trial("cube.fe").out("plateau"), "triple lines (120)             none\n"));
  EXPECT_TRUE(contains(Trial().failure("plateau all"), "plateau takes no arguments"));
}

}  // namespace
}  // namespace lamella::trial
