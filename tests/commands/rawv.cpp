#include "support/trial.h"

namespace lamella::trial {
namespace {

// Numbers of Surface Evolver: a quarter of the way to the mean of the neighbours, weighted by the squared
// areas at their edges.
TEST(Rawv, GoesAsFarAsEvolver) {
  const Folder folder;
  const std::string path =
      folder.write("flat.fe",
                   "vertices\n1 0 0 0 fixed\n2 1 0 0 fixed\n3 1 1 0 fixed\n4 0 1 0.3 fixed\n"
                   "5 0.3 0.2 0.2\nedges\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n5 1 5\n6 2 5\n7 3 5\n"
                   "8 4 5\nfaces\n1 1 6 -5\n2 2 7 -6\n3 3 8 -7\n4 4 5 -8\n");
  Trial trial;
  trial.out("load \"" + path + "\"; rawv");
  EXPECT_NEAR(trial.number("vertex[5].x"), 0.390159409173, 1e-11);
  EXPECT_NEAR(trial.number("vertex[5].z"), 0.169851185123, 1e-11);
  trial.out("load \"" + path + "\"; V");
  EXPECT_NEAR(trial.number("vertex[5].x"), 0.395401531273, 1e-11);
  EXPECT_NEAR(trial.number("vertex[5].z"), 0.204798665788, 1e-11);
}

TEST(Rawv, AlongTripleLines) {
  Trial trial("double_bubble.fe");
  trial.out("r; set vertex x x*(1+0.3*y+0.1*z*z)");
  trial.out("nr := 0; foreach vertex vv where max(vv.edge, valence) == 3 do { nr := vv.id; break }");
  trial.out("mx := 0; foreach vertex[nr].edge ee where ee.valence == 3 do mx += ee.vertex[2].x/2");
  const double expected = trial.number("0.75*vertex[nr].x + 0.25*mx");
  trial.out("raw_vertex_average vertex[nr]");
  EXPECT_NEAR(trial.number("vertex[nr].x"), expected, 1e-14);
}

TEST(Rawv, Refuses) {
  EXPECT_TRUE(contains(Trial("cube.fe").failure("rawv edge[1]"), "only vertices can be averaged"));
  EXPECT_TRUE(contains(Trial().failure("rawv"), "there is no film to average"));
}

}  // namespace
}  // namespace lamella::trial
