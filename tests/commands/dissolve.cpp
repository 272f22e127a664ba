#include "support/trial.h"

namespace lamella::trial {
namespace {

TEST(Dissolve, OnlyWhatNothingIsMadeOf) {
  Trial trial("cube.fe");
  trial.session().set_quiet(false);
  EXPECT_EQ(trial.out("dissolve edges; dissolve vertices"), "");
  EXPECT_EQ(trial.out("dissolve facets where id == 1"), "Facets dissolved: 1\n");
  EXPECT_EQ(trial.number("facet_dissolve_count"), 1);
  EXPECT_EQ(trial.number("facet_count"), 23);
  EXPECT_EQ(trial.out("dissolve facets; dissolve edges; dissolve vertices; dissolve bodies"),
            "Facets dissolved: 23\nEdges dissolved: 36\nVertices dissolved: 14\nBodies dissolved: 1\n");
  EXPECT_EQ(trial.number("vertex_count + edge_count + facet_count + body_count"), 0);
}

// A facet between two bodies parts them; it stays.
TEST(Dissolve, KeepsWalls) {
  Trial trial("double_bubble.fe");
  const double walls = trial.number("count(facet where frontbody != 0 and backbody != 0)");
  trial.out("dissolve facets");
  EXPECT_EQ(trial.number("facet_count"), walls);
  trial.out("dissolve body[1]; dissolve facets");
  EXPECT_EQ(trial.number("facet_count"), 0);
}

}  // namespace
}  // namespace lamella::trial
