#include "support/trial.h"

namespace lamella::trial {
namespace {

TEST(Report, TellsAllAtAGlance) {
  Trial trial("cube.fe");
  const std::string printed = trial.out("report");
  EXPECT_TRUE(printed.starts_with("Scene: " + datafile("cube.fe") +
                                  "\nVertices: 14  Edges: 36  Facets: 24  Bodies: 1  Facetedges: 72\n"
                                  "Energy: 6  Area: 6  Time: 0\n"
                                  "Volumes: kept, largest relative error 0\n"
                                  "Edges: 0.7071 to 1  Smallest angle: 45.00 degrees\n"
                                  "Memory: "))
      << printed;
  EXPECT_TRUE(printed.ends_with(" bytes a facet for the film\n"));
  EXPECT_EQ(trial.out("i"), printed);
}

TEST(Report, TellsOfVolumesAndAngles) {
  Trial trial("double_bubble.fe");
  EXPECT_TRUE(contains(trial.out("refine 2; relax; vc off; i"), "Volumes: free, "));
  EXPECT_TRUE(contains(trial.out("i"), "\nTriple lines: rms 1.93"));
  EXPECT_FALSE(contains(trial.out("i"), "Quad points"));
  EXPECT_TRUE(
      contains(trial.out("vc on; body[1].target := 2; i"), "Volumes: kept, largest relative error 0.5\n"));
}

// About 100 bytes a facet without optional columns, as long as rows stand in the order of their numbers.
TEST(Report, AFilmIsSmall) {
  Trial trial("cube.fe");
  const std::string printed = trial.out("refine 4; i");
  const std::string before = "Memory: ";
  const double bytes = std::stod(printed.substr(printed.find(before) + before.size()));
  EXPECT_LT(bytes, 110);
}

TEST(Report, OfNothing) {
  EXPECT_EQ(Trial().out("report"),
            "Scene: (none)\nVertices: 0  Edges: 0  Facets: 0  Bodies: 0  Facetedges: 0\n");
  EXPECT_TRUE(contains(Trial().failure("i 1"), "i takes no arguments"));
}

}  // namespace
}  // namespace lamella::trial
