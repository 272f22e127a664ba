#include <cmath>

#include "support/trial.h"

namespace lamella::trial {
namespace {

constexpr double sphere = 4.835975862049;  // area around volume 1

TEST(Relax, DoubleBubble) {
  Trial trial("double_bubble.fe");
  trial.out("refine; refine; relax");
  EXPECT_NEAR(trial.number("total_area"), 9.158, 5e-4);
  EXPECT_LT(trial.number("triple_angle_rms"), 2.2);
  EXPECT_NEAR(trial.number("body[1].volume"), 1, 1e-12);
  EXPECT_NEAR(trial.number("body[2].volume"), 1, 1e-12);
  EXPECT_NEAR(trial.number("body[1].pressure"), trial.number("body[2].pressure"), 1e-3);
  EXPECT_EQ(trial.number("relax_converged"), 1);
  EXPECT_LT(trial.number("relax_residual"), 1e-10);
}

// Errors fall fourfold with each refinement.
TEST(Relax, TheCubeTendsToTheSphereAtSecondOrder) {
  Trial trial("cube.fe");
  trial.out("refine");
  double before = 0;
  for (int level = 2; level <= 5; ++level) {
    trial.out("refine; relax");
    const double error = trial.number("total_area") - sphere;
    EXPECT_GT(error, 0);
    if (before > 0) EXPECT_NEAR(std::log2(before / error), 2, 0.25) << level;
    before = error;
  }
  EXPECT_LT(before, 8e-3);
}

TEST(Relax, TheWireCubeTendsToItsThirteenFilms) {
  Trial trial("wire_cube.fe");
  trial.out("refine 3; relax");
  const double coarse = trial.number("total_area") - 4.23956311;
  trial.out("refine; relax");
  const double fine = trial.number("total_area") - 4.23956311;
  EXPECT_GT(fine, -1e-6);
  EXPECT_LT(std::abs(fine), 0.5 * std::abs(coarse) + 1e-6);
  EXPECT_LT(fine, 2e-3);
}

TEST(Relax, TellsHowItEnded) {
  Trial trial("cube.fe");
  trial.session().set_quiet(false);
  trial.out("refine 2");
  EXPECT_TRUE(trial.out("relax 3").starts_with("step limit reached after 3 iterations: energy "));
  EXPECT_EQ(trial.number("relax_converged"), 0);
  EXPECT_TRUE(trial.out("relax").starts_with("converged after "));
  EXPECT_TRUE(trial.out("relax 0").starts_with("converged after 0 iterations"));
}

TEST(Relax, Options) {
  Trial trial("cube.fe");
  trial.out("refine 3");
  const double start = trial.number("total_area");
  for (const char* line :
       {"relax 30 method descent", "relax motion full keep_mesh", "relax motion normal keep_mesh",
        "relax keep_mesh", "relax tolerance 1e-6", "relax method lbfgs tolerance=1e-4"}) {
    trial.out(line);
    EXPECT_LT(trial.number("total_area"), 0.9 * start) << line;
    EXPECT_NEAR(trial.number("body[1].volume"), 1, 1e-12) << line;
    EXPECT_EQ(trial.number("edge[1].valence"), 2);
    trial.out("undo");
  }
}

// Without flips the connectivity stays.
TEST(Relax, KeepMeshKeepsTheMesh) {
  Trial trial("double_bubble.fe");
  const char* edges = "foreach edge ee do printf \"%d %d\\n\", ee.vertex[1].id, ee.vertex[2].id";
  const std::string before = trial.out(std::string("refine 2; ") + edges);
  EXPECT_EQ(trial.out(std::string("relax keep_mesh; ") + edges), before);
}

TEST(Relax, FreeFilmsAndWires) {
  const Folder folder;
  const std::string wire = folder.write("wire.fe",
                                        "vertices\n1 0 0 0 fixed\n2 1 1 0\n3 2 0 0 fixed\n"
                                        "edges\n1 1 2 tension 1 bare\n2 2 3 tension 1 bare\n");
  Trial trial;
  trial.session().load(wire);
  trial.out("relax");
  EXPECT_NEAR(trial.number("vertex[2].y"), 0, 1e-4);
  EXPECT_NEAR(trial.number("total_energy"), 2, 1e-9);
  // Nothing pulls here, so all is at rest.
  trial.out("unset edge tension; set vertex[2] y 1; relax");
  EXPECT_EQ(trial.number("relax_converged"), 1);
  EXPECT_EQ(trial.number("vertex[2].y"), 1);
  // A film that nothing holds shrinks to a point.
  trial.session().load(folder.write("free.fe",
                                    "vertices\n1 0 0 0\n2 1 0 0\n3 0 1 0\n"
                                    "edges\n1 1 2\n2 2 3\n3 3 1\nfaces\n1 1 2 3\n"));
  trial.out("relax");
  EXPECT_LT(trial.number("total_area"), 1e-12);
}

TEST(Relax, WhatCannotMoveIsAtRest) {
  for (const char* file : {"tricky/only_vertices.fe", "cube.fe"}) {
    Trial trial(file);
    trial.out("fix vertex; vc off; relax");
    EXPECT_EQ(trial.number("relax_converged"), 1) << file;
  }
}

TEST(Relax, Refuses) {
  Trial trial("cube.fe");
  EXPECT_TRUE(contains(trial.failure("relax -1"), "test:1:7: error: steps must be at least 0, not -1"));
  EXPECT_TRUE(
      contains(trial.failure("relax tolerance 0"), "test:1:17: error: tolerance must be greater than 0"));
  EXPECT_TRUE(
      contains(trial.failure("relax method newton"), "method is one of lbfgs, descent, not \"newton\""));
  EXPECT_TRUE(contains(trial.failure("relax motion sideways"), "motion is one of normal, full"));
  EXPECT_TRUE(contains(trial.failure("relax method descent motion full"),
                       "steepest descent knows no kinds of motion"));
  EXPECT_TRUE(contains(trial.failure("relax keepmesh"), "did you mean \"keep_mesh\"?"));
  EXPECT_TRUE(contains(trial.failure("{ fix vertex; body[1].target := 2; relax }"),
                       "cannot be brought to their targets"));
  EXPECT_TRUE(contains(Trial().failure("relax"), "there is no film to relax"));
  EXPECT_EQ(trial.number("total_area"), 6);
}

}  // namespace
}  // namespace lamella::trial
