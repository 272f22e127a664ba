#include "support/trial.h"

namespace lamella::trial {
namespace {

TEST(Refine, PrintsEvolversRow) {
  Trial trial("cube.fe");
  trial.session().set_quiet(false);
  EXPECT_EQ(trial.out("r"), "Vertices: 50  Edges: 144  Facets: 96  Bodies: 1  Facetedges: 288\n");
  EXPECT_EQ(trial.out("print edge_refine_count; print facet_refine_count"), "36\n24\n");
  EXPECT_EQ(trial.out("refine 2"),
            "Vertices: 194  Edges: 576  Facets: 384  Bodies: 1  Facetedges: 1152\n"
            "Vertices: 770  Edges: 2304  Facets: 1536  Bodies: 1  Facetedges: 4608\n");
  EXPECT_EQ(trial.out("refine 0"), "");
  EXPECT_NEAR(trial.number("total_area"), 6, 1e-13);
  EXPECT_NEAR(trial.number("body[1].volume"), 1, 1e-14);
}

TEST(Refine, ChosenElements) {
  Trial trial("cube.fe");
  trial.session().set_quiet(false);
  EXPECT_EQ(trial.out("refine edges where length > 0.9"), "Edges refined: 12\n");
  EXPECT_EQ(trial.number("edge_refine_count"), 12);
  EXPECT_EQ(trial.out("refine facets where id < 3; print facet_refine_count"), "Facets refined: 2\n2\n");
  EXPECT_EQ(trial.number("facet_count"), 24 + 24 + 4);
  EXPECT_EQ(trial.out("refine edge[1]"), "Edges refined: 1\n");
  EXPECT_EQ(trial.out("refine facet[2].edge"), "Edges refined: 3\n");
  EXPECT_EQ(trial.out("refine edges where length > 5"), "Edges refined: 0\n");
  EXPECT_EQ(trial.number("edge_refine_count"), 0);
  EXPECT_EQ(trial.out("check"), "Checks completed.\n");
  EXPECT_NEAR(trial.number("body[1].volume"), 1, 1e-14);
}

// Wires shape the film: they stay where they are, and what lies on them is held.
TEST(Refine, NewVerticesInherit) {
  Trial trial("wire_cube.fe");
  const double wires = trial.number("sum(edge where fixed, length)");
  const double held = trial.number("count(vertex where fixed)");
  const double fixed_edges = trial.number("count(edge where fixed)");
  trial.out("refine");
  EXPECT_EQ(trial.number("count(vertex where fixed)"), held + fixed_edges);
  EXPECT_NEAR(trial.number("sum(edge where fixed, length)"), wires, 1e-12);
}

TEST(Refine, Refuses) {
  Trial trial("cube.fe");
  EXPECT_TRUE(contains(trial.failure("refine -1"), "test:1:8: error: times must be at least 0, not -1"));
  EXPECT_TRUE(contains(trial.failure("refine 1e9"), "times must be at most 20"));
  EXPECT_TRUE(
      contains(trial.failure("refine 20"), "that would make 2.64e+13 facets, more than fit into memory"));
  EXPECT_TRUE(contains(trial.failure("refine vertices"), "only edges and facets can be refined"));
  EXPECT_TRUE(contains(trial.failure("refine edge[999]"), "999"));
  EXPECT_TRUE(contains(trial.failure("refine edges where lenght > 1"), "did you mean \"length\"?"));
  EXPECT_TRUE(contains(Trial().failure("refine"), "there is no film to refine"));
  EXPECT_EQ(trial.number("facet_count"), 24);
}

}  // namespace
}  // namespace lamella::trial
