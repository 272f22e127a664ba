#include "support/trial.h"

namespace lamella::trial {
namespace {

// Two films that never meet, listed as one body.
TEST(Rebody, DividesWhatDoesNotHangTogether) {
  Trial trial("cube.fe");
  trial.out(
      "r; va := new_vertex(3,0,0); vb := new_vertex(4,0,0); vc := new_vertex(3,1,0); vd := new_vertex(3,0,1);"
      "e1 := new_edge(va,vb); e2 := new_edge(vb,vc); e3 := new_edge(vc,va);"
      "e4 := new_edge(va,vd); e5 := new_edge(vb,vd); e6 := new_edge(vc,vd)");
  trial.out(
      "f1 := new_facet(-e1,-e3,-e2); f2 := new_facet(e1,e5,-e4); f3 := new_facet(e2,e6,-e5);"
      "f4 := new_facet(e3,e4,-e6)");
  trial.out("set facet frontbody 1 where id == f1 or id == f2 or id == f3 or id == f4");
  EXPECT_NEAR(trial.number("body[1].volume"), 1 + 1.0 / 6, 1e-12);
  trial.session().set_quiet(false);
  EXPECT_EQ(trial.out("rebody"), "New bodies: 1\n");
  EXPECT_NEAR(trial.number("body[1].volume"), 1, 1e-12);
  EXPECT_NEAR(trial.number("body[1].target"), 1, 1e-12);
  EXPECT_NEAR(trial.number("body[2].volume"), 1.0 / 6, 1e-12);
  EXPECT_NEAR(trial.number("body[2].target"), 1.0 / 6, 1e-12);
  EXPECT_EQ(trial.number("body[2].original"), 1);
  EXPECT_EQ(trial.out("rebody"), "New bodies: 0\n");
}

}  // namespace
}  // namespace lamella::trial
