#include <cmath>

#include "support/trial.h"

namespace lamella::trial {
namespace {

// Four cells around an edge in the middle of a square.
constexpr const char* four_cells = R"(string
space_dimension 2
vertices
1 -0.1 0
2 0.1 0
3 -1 1 fixed
4 -1 -1 fixed
5 1 -1 fixed
6 1 1 fixed
edges
1 1 2
2 1 3
3 1 4
4 2 5
5 2 6
6 3 4
7 4 5
8 5 6
9 6 3
faces
1  -2 3 -6
2  -3 1 4 -7
3  -4 5 -8
4  -5 -1 2 -9
bodies
1 1
2 2
3 3
4 4
)";

class T1Edgeswap : public testing::Test {
 protected:
  T1Edgeswap() { trial.out("load \"" + folder_.write("four.fe", four_cells) + "\""); }
  double length(int edge) { return trial.number("edge[" + std::to_string(edge) + "].length"); }
  double area(int body) { return trial.number("body[" + std::to_string(body) + "].volume"); }

  Folder folder_;
  Trial trial;
};

TEST_F(T1Edgeswap, TurnsTheEdge) {
  trial.session().set_quiet(false);
  const std::string told = trial.out("t1_edgeswap edge[1]");
  EXPECT_TRUE(contains(told, "T1 swaps: 1\n")) << told;
  EXPECT_EQ(trial.number("t1_edgeswap_count"), 1);
  trial.session().set_quiet(true);
  EXPECT_NEAR(length(1), 0.2, 1e-15);
  for (const int edge : {2, 3, 4, 5}) EXPECT_NEAR(length(edge), std::hypot(1, 0.9), 1e-14) << edge;
  // Of the strings at each end of the edge those stay or come that they do in Surface Evolver.
  for (const auto& [edge, end] : {std::pair(2, 1), {3, 2}, {4, 2}, {5, 1}})
    EXPECT_EQ(trial.number("edge[" + std::to_string(edge) + "].vertex[1].id"), end) << edge;
  // Cells of the sides now reach in to the middle, those above and below end at the edge.
  for (const int body : {1, 3}) EXPECT_NEAR(std::abs(area(body)), 1.1, 1e-14) << body;
  for (const int body : {2, 4}) EXPECT_NEAR(std::abs(area(body)), 0.9, 1e-14) << body;
  EXPECT_NEAR(trial.number("sum(body bb, bb.volume)"), -4, 1e-14);
  trial.out("check");
}

TEST_F(T1Edgeswap, TurnedTwiceIsAsItWas) {
  trial.out("t1_edgeswap edge[1]; t1_edgeswap edge[1]");
  EXPECT_NEAR(std::abs(area(1)), 0.9, 1e-15);
  EXPECT_NEAR(std::abs(area(2)), 1.1, 1e-15);
  trial.out("g 20; hessian; hessian");
  EXPECT_NEAR(trial.number("total_length"), 10 + 2 * std::sqrt(3), 1e-12);  // angles of 120 degrees
}

TEST_F(T1Edgeswap, LeavesOutWhatHasNotThreeStrings) {
  trial.out("t1_edgeswap edge where id > 1");
  EXPECT_EQ(trial.number("t1_edgeswap_count"), 0);
  trial.out("fix vertex[1]; t1_edgeswap edge[1]");
  EXPECT_EQ(trial.number("t1_edgeswap_count"), 0);
  EXPECT_EQ(trial.number("vertex[1].x"), -0.1);
}

TEST(T1EdgeswapOfFacets, IsRefused) {
  EXPECT_TRUE(contains(Trial("cube.fe").failure("t1_edgeswap edge[1]"), "for films of one dimension"));
}

}  // namespace
}  // namespace lamella::trial
