#include "support/evolver.h"
#include "support/trial.h"

namespace lamella::trial {
namespace {

TEST(Addload, PutsAFilmBesideTheOther) {
  Trial trial("drop_on_table.fe");
  const double area = trial.number("total_area");
  const double energy = trial.number("total_energy");
  const double vertices = trial.number("vertex_count");
  trial.out("define vertex attribute part integer; set vertex part 7");
  trial.out("addload datafilename; set vertex x x + 5 where part == 0; recalc; check");
  EXPECT_EQ(trial.number("vertex_count"), 2 * vertices);
  EXPECT_EQ(trial.number("body_count"), 2);
  EXPECT_NEAR(trial.number("total_area"), 2 * area, 1e-13);
  EXPECT_NEAR(trial.number("total_energy"), 2 * energy, 1e-12);
  EXPECT_EQ(trial.number("count(vertex where on_constraint 1 and part == 0)"),
            trial.number("count(vertex where on_constraint 1 and part == 7)"));
  trial.out("r; g 5; relax; check");
  EXPECT_NEAR(trial.number("body[1].volume"), trial.number("body[2].volume"), 1e-12);
  EXPECT_NEAR(trial.number("body[1].pressure"), trial.number("body[2].pressure"), 1e-6);
}

TEST(Addload, AFailureLeavesTheScene) {
  Trial trial("cube.fe");
  const Folder folder;
  EXPECT_TRUE(contains(
      trial.failure(
          "addload \"" +
          folder.write("s.fe", "string\nspace_dimension 2\nvertices\n1 0 0\n2 1 0\nedges\n1 1 2\n") + "\""),
      "only films of facets"));
  EXPECT_TRUE(contains(trial.failure("addload nothing.fe"), "cannot read"));
  EXPECT_EQ(trial.number("body_count"), 1);
  trial.out("check");
}

// Nine drops with nine angles of contact, set up by the example's own script.
TEST(Addload, AsInEvolver) {
  const std::string file = evolver_example("addload_example");
  if (!evolver_is_installed() || !std::filesystem::exists(file)) GTEST_SKIP() << "needs Surface Evolver";
  Trial trial;
  trial.session().load(file);
  EXPECT_EQ(trial.number("body_count"), 9);
  trial.run("gogo");
  const double theirs = evolver_number(file, "gogo", "total_energy");
  EXPECT_NEAR(trial.number("total_energy"), theirs, 1e-4 * theirs);
}

}  // namespace
}  // namespace lamella::trial
