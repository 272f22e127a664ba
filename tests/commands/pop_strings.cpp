#include "support/evolver.h"
#include "support/trial.h"

namespace lamella::trial {
namespace {

constexpr const char* cross = R"(
string
space_dimension 2
vertices
1 0 0 fixed
2 2 0 fixed
3 2 1 fixed
4 0 1 fixed
5 1 .5
edges
1 1 5
2 2 5
3 3 5
4 4 5
5 1 2 fixed
6 2 3 fixed
7 3 4 fixed
8 4 1 fixed
faces
1 5 2 -1
2 6 3 -2
3 7 4 -3
4 8 1 -4
bodies
1 1
2 2
3 3
4 4
)";

// Four strings at one point become two points with three; each cell's area follows, and their sum stays.
TEST(PopStrings, CellsKeepTheirLoops) {
  const Folder folder;
  Trial trial;
  trial.out("load \"" + folder.write("cross.fe", cross) + "\"");
  EXPECT_EQ(trial.out("o"), "");
  EXPECT_EQ(trial.number("vertex_pop_count"), 1);
  EXPECT_EQ(trial.number("vertex_count"), 6);
  EXPECT_EQ(trial.number("edge_count"), 9);
  EXPECT_NEAR(trial.number("sum(body, volume)"), 2, 1e-14);
  trial.out("hessian_normal off; g 200; check");
  // Steiner's tree of a rectangle 2 x 1.
  EXPECT_NEAR(trial.number("sum(edges where not fixed, length)"), 2 + std::sqrt(3.0), 1e-9);
  EXPECT_NEAR(trial.number("sum(body, volume)"), 2, 1e-13);
  EXPECT_NEAR(trial.number("body[1].volume"), trial.number("body[3].volume"), 1e-6);
  EXPECT_EQ(trial.number("count(vertex where valence > 3)"), 0);
}

// Where the peer is installed: the same vertices, and the same rows of g.
TEST(PopStrings, AsInEvolver) {
  const std::string file = evolver_example("popstr");
  if (!evolver_is_installed() || !std::filesystem::exists(file)) GTEST_SKIP() << "needs Surface Evolver";
  Trial trial;
  trial.session().load(file);
  trial.run("gogo");
  EXPECT_NEAR(trial.number("total_energy"), evolver_number(file, "gogo", "total_energy"), 1e-12);
}

}  // namespace
}  // namespace lamella::trial
