#include "film/check.h"
#include "support/trial.h"

namespace lamella::trial {
namespace {

// The edge from vertex 5 to the middle 19 of a cube's edge: the ends meet halfway, with the number of the
// tail. Surface Evolver leaves the same edges.
TEST(Delete, JoinsTheEndsHalfway) {
  Trial trial("cube.fe");
  trial.out("r; delete edge[5]");
  EXPECT_EQ(trial.number("edge_delete_count"), 1);
  EXPECT_EQ(trial.number("vertex[5].x"), 0.25);
  EXPECT_EQ(trial.number("valid_element(vertex[19])"), 0);
  EXPECT_EQ(trial.number("edge[100].vertex[1].id"), 5);
  EXPECT_EQ(trial.number("edge[116].vertex[2].id"), 5);
  EXPECT_EQ(trial.number("valid_element(edge[17])"), 0);
  EXPECT_EQ(trial.out("c; check; print check_count"),
            "Vertices: 49  Edges: 141  Facets: 94  Bodies: 1  Facetedges: 282\n0\n");
}

TEST(Delete, KeepsWhatIsFixed) {
  Trial trial("cube.fe");
  trial.out("r; fix vertex[20]; delete edge[6]");
  EXPECT_EQ(trial.number("vertex[20].x"), 1);
  EXPECT_EQ(trial.number("vertex[20].y"), 0.5);
  EXPECT_EQ(trial.number("valid_element(vertex[6])"), 0);
  trial.out("fix vertex[7]; fix vertex[21]; delete edge[7]");
  EXPECT_EQ(trial.number("edge_delete_count"), 0);
  trial.out("fix edge[8]; delete edge[8]");
  EXPECT_EQ(trial.number("edge_delete_count"), 0);
  EXPECT_EQ(trial.number("vertex_count"), 49);
}

// Counts and areas as in Surface Evolver 2.70.
TEST(Delete, CollapsesAsEvolverDoes) {
  Trial trial("double_bubble.fe");
  trial.out("r; r; set vertex x x*(1+0.3*y+0.1*z*z); set vertex z z*(1+0.2*x*y)");
  trial.session().set_quiet(false);
  EXPECT_EQ(trial.out("delete edges where length < .13"), "Edges deleted: 27\n");
  EXPECT_EQ(trial.out("printf \"%g\\n\", total_area"), "10.6245\n");
  EXPECT_EQ(trial.out("delete facets where area < .012"), "Facets deleted: 216\n");
  EXPECT_EQ(trial.out("c; check"),
            "Vertices: 275  Edges: 835  Facets: 563  Bodies: 2  Facetedges: 1689\nChecks completed.\n");
  EXPECT_EQ(trial.out("printf \"%g\\n\", total_area"), "10.2469\n");
}

// Without end, a closed film is left with its last facets: nothing that cannot be a film comes of it.
// Whether films come to pass through one another is not asked: it does as it is told.
TEST(Delete, NeverBreaksTheFilm) {
  for (const char* const file : {"cube.fe", "catenoid.fe", "double_bubble.fe", "wire_cube.fe"}) {
    Trial trial(file);
    trial.out("r; delete edges");
    EXPECT_EQ(film::check(trial.session().scene().film), std::vector<std::string>{}) << file;
    trial.out("delete facets; delete edges");
    EXPECT_EQ(film::check(trial.session().scene().film), std::vector<std::string>{}) << file;
    EXPECT_GT(trial.number("facet_count"), 0) << file;
  }
}

TEST(Delete, Refuses) {
  Trial trial("cube.fe");
  EXPECT_TRUE(contains(trial.failure("delete vertex[3]"), "only edges and facets can be deleted"));
  EXPECT_TRUE(contains(trial.failure("delete"), "delete needs elements"));
}

}  // namespace
}  // namespace lamella::trial
