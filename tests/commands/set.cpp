#include "support/trial.h"

namespace lamella::trial {
namespace {

TEST(Set, GivesValuesToChosenElements) {
  Trial trial("cube.fe");
  EXPECT_EQ(trial.out("set vertices x 3*x where id < 5; print vertex[2].x; print vertex[6].x"), "3\n1\n");
  EXPECT_EQ(trial.out("set facet color red where original == 2; print count(facet where color == red)"),
            "4\n");
  EXPECT_EQ(trial.out("set edge[1] color blue; print edge[1].color"), "1\n");
  EXPECT_EQ(trial.out("set vertex fixed where z == 1; print count(vertex where fixed)"), "5\n");
  EXPECT_EQ(trial.out("set vertex[7] fixed 0; print vertex[7].fixed"), "0\n");
  EXPECT_EQ(trial.out("foreach facet ff do set ff color green; print facet[9].color"), "2\n");
  EXPECT_EQ(trial.out("set vertex[1].facet color yellow; print count(facet where color == yellow)"),
            trial.out("print count(vertex[1].facet, 1)"));
  EXPECT_EQ(trial.out("define vertex attribute heat real; set vertex vv heat vv.x + 1; print vertex[1].heat"),
            "1\n");
  EXPECT_EQ(trial.out("set body target 5 where id == 1; print body[1].target"), "5\n");
}

TEST(Set, FailsAsAWhole) {
  Trial trial("cube.fe");
  EXPECT_TRUE(contains(trial.failure("set vertex x 1/(id - 3)"), "division by zero"));
  EXPECT_EQ(trial.number("vertex[2].x"), 1);
  EXPECT_TRUE(contains(trial.failure("set vertex x"), "needs its value"));
  EXPECT_TRUE(contains(trial.failure("set edge length 3"), "cannot be set"));
  EXPECT_TRUE(contains(trial.failure("set vertex"), "attribute of vertices"));
  EXPECT_TRUE(contains(trial.failure("set nonsense 3"), "set does not take"));
}

}  // namespace
}  // namespace lamella::trial
