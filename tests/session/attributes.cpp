#include <numbers>

#include "support/trial.h"

namespace lamella::trial {
namespace {

TEST(Attributes, OfVertices) {
  Trial trial("cube.fe");
  EXPECT_EQ(trial.out("v := 7; print vertex[7].x; print vertex[v].__x; print vertex[7].x3"),
            "1\n{1, 1, 1}\n1\n");
  EXPECT_EQ(trial.number("vertex[1].valence"), 6);
  EXPECT_EQ(trial.number("vertex[3].original"), 3);
  EXPECT_EQ(trial.number("vertex[14].original"), 0);
  EXPECT_EQ(trial.out("vertex[2].__x[3] := 0.5; print vertex[2].z"), "0.5\n");
  EXPECT_EQ(trial.out("vertex[2].fixed := 1; print vertex[2].fixed; print vertex[1].fixed"), "1\n0\n");
}

TEST(Attributes, MeanCurvature) {
  Trial trial("cube.fe");
  trial.out("refine 4; relax");
  const double radius = std::cbrt(3 / (4 * 3.14159265358979));
  EXPECT_NEAR(trial.number("avg(vertex, mean_curvature)"), 1 / radius, 0.01);
  EXPECT_NEAR(trial.number("max(vertex, mean_curvature)"), 1 / radius, 0.1);
  EXPECT_EQ(Trial("wire_cube.fe").number("vertex[1].mean_curvature"), 0);  // a corner of the wire
}

TEST(Attributes, OfEdges) {
  Trial trial("cube.fe");
  EXPECT_EQ(trial.number("edge[1].length"), 1);
  EXPECT_EQ(trial.number("edge[1].x"), 1);
  EXPECT_EQ(trial.number("edge[-1].x"), -1);
  EXPECT_EQ(trial.number("edge[-1].oid"), -1);
  EXPECT_EQ(trial.number("edge[1].valence"), 2);
  EXPECT_EQ(trial.number("edge[1].wire"), 0);
  EXPECT_NEAR(trial.number("edge[1].dihedral"), std::numbers::pi / 2, 1e-14);
  EXPECT_NEAR(trial.number("edge[13].dihedral"), 0, 1e-15);
  EXPECT_EQ(trial.out("edge[1].color := red; print edge[1].color; print edge[2].color"), "4\n0\n");
  EXPECT_EQ(trial.out("edge[1].tension := 2; print edge[1].density; print edge[2].density"), "2\n0\n");
}

TEST(Attributes, OfFacets) {
  Trial trial("cube.fe");
  EXPECT_NEAR(trial.number("facet[1].area"), 0.25, 1e-15);
  EXPECT_NEAR(trial.number("facet[1].z"), -0.25, 1e-15);
  EXPECT_NEAR(trial.number("facet[-1].z"), 0.25, 1e-15);
  EXPECT_EQ(trial.number("facet[1].frontbody"), 1);
  EXPECT_EQ(trial.number("facet[1].backbody"), 0);
  EXPECT_EQ(trial.number("facet[1].tension"), 1);
  EXPECT_EQ(trial.number("facet[1].color"), 15);
  EXPECT_EQ(trial.out("facet[1].color := red; print facet[1].backcolor"), "4\n");
  EXPECT_EQ(trial.out("facet[1].frontcolor := blue; print facet[1].backcolor; print facet[1].color"),
            "4\n1\n");
  EXPECT_EQ(trial.out("facet[2].backcolor := green; print facet[2].backcolor; print facet[2].color"),
            "2\n15\n");
  EXPECT_EQ(trial.out("foreach facet[1].body bb do print bb.id"), "1\n");
}

TEST(Attributes, OfBodies) {
  Trial trial("cube.fe");
  EXPECT_NEAR(trial.number("body[1].volume"), 1, 1e-14);
  EXPECT_EQ(trial.number("body[1].target"), 1);
  EXPECT_EQ(trial.number("body[1].volfixed"), 1);
  EXPECT_EQ(trial.out("body[1].target := 2; print body[1].target"), "2\n");
  EXPECT_EQ(trial.out("set body target 3 where id == 1; print body[1].target"), "3\n");
  EXPECT_TRUE(contains(trial.failure("body[1].pressure := 3"), "unset body[1] target"));
  EXPECT_EQ(
      trial.out(
          "unset body[1] target; print body[1].volfixed; body[1].pressure := 3; print body[1].pressure"),
      "0\n3\n");
  EXPECT_TRUE(contains(trial.failure("body[1].target := -1"), "positive"));
  Trial heavy("cube.fe");
  EXPECT_EQ(heavy.out("body[1].density := 2; print body[1].density; print total_energy > total_area"),
            "2\n1\n");
  EXPECT_EQ(trial.number("count(body[1].facet, 1)"), 24);
  EXPECT_EQ(trial.number("body[1].valence"), 24);
}

TEST(Attributes, OfTheUser) {
  Trial trial("cube.fe");
  EXPECT_EQ(trial.out("define vertex attribute heat real[2]; set vertex heat[2] id; print vertex[5].heat; "
                      "print vertex[5].heat[2]"),
            "{0, 5}\n5\n");
  EXPECT_TRUE(contains(trial.failure("print vertex[1].heat[3]"), "not between 1 and 2"));
  EXPECT_TRUE(contains(trial.failure("x := vertex[1].heat"), "name the component"));
  EXPECT_EQ(trial.out("define edge attribute flow integer; edge[1].flow := 2.6; print edge[1].flow"), "3\n");
  EXPECT_TRUE(contains(trial.failure("undo 4; print vertex[1].heat[2]"), "no attribute"));
}

TEST(Attributes, CannotBeSetToNonsense) {
  Trial trial("cube.fe");
  EXPECT_TRUE(contains(trial.failure("vertex[1].x := 10^308*10"), "inf"));
  EXPECT_TRUE(contains(trial.failure("facet[1].color := 2.5"), "no color"));
  EXPECT_TRUE(contains(trial.failure("facet[1].frontbody := 7"), "no body 7"));
  EXPECT_TRUE(contains(trial.failure("vertex[1].id := 7"), "cannot be set"));
}

TEST(InternalVariables, TellOfTheScene) {
  Trial trial("double_bubble.fe");
  EXPECT_EQ(trial.number("vertex_count - edge_count + facet_count"), trial.number("33 - 96 + 66"));
  EXPECT_EQ(trial.number("body_count"), 2);
  EXPECT_EQ(trial.number("total_area"), trial.number("total_energy"));
  EXPECT_NEAR(trial.number("total_area"), trial.number("sum(facet, area)"), 1e-13);
  EXPECT_NEAR(trial.number("total_length"), trial.number("sum(edge, length)"), 1e-12);
  EXPECT_TRUE(contains(trial.out("print datafilename"), "double_bubble.fe"));
  EXPECT_EQ(trial.out("random_seed := 5; a := random; random_seed := 5; print a == random; print random < 1"),
            "1\n1\n");
  EXPECT_EQ(trial.out("gravity_constant := 2; print gravity_constant; gravity := 0; print gravity"),
            "2\n0\n");
}

}  // namespace
}  // namespace lamella::trial
