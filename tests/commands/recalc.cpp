#include "support/trial.h"

namespace lamella::trial {
namespace {

TEST(Recalc, IsTakenAnywhere) {
  Trial trial("cube.fe");
  EXPECT_EQ(trial.out("set vertex x 2*x; recalc; print total_area"), "10\n");
  EXPECT_EQ(trial.out("showq; close_show; whereami; free_discards"), "");
}

// As in Surface Evolver: parameters take vertices along, fixed ones too.
TEST(Recalc, PutsVerticesOntoWhatHasMoved) {
  const Folder folder;
  Trial trial;
  trial.session().load(folder.write("lifted.fe", R"(
parameter height = 1
constraint 1
formula: z = height
boundary 1 parameters 1
x1: cos(p1)
x2: sin(p1)
x3: 2*height
vertices
1 0 0 1 constraint 1 fixed
2 1 0 1 constraint 1
3 1.5 boundary 1 fixed
edges
1 1 2
2 2 3
3 3 1
faces
1 1 2 3
)"));
  EXPECT_EQ(trial.out("height := 1.5; foreach vertex v do print v.z"), "1.5\n1.5\n3\n");
  EXPECT_EQ(
      trial.out("autorecalc off; height := 2; print vertex[1].z; recalc; foreach vertex v do print v.z"),
      "1.5\n2\n2\n4\n");
  EXPECT_EQ(trial.out("set vertex z 7; foreach vertex v do print v.z"), "2\n2\n4\n");
}

}  // namespace
}  // namespace lamella::trial
