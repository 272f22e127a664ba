#include "support/trial.h"

namespace lamella::trial {
namespace {

// A flat film of two facets that meet along the longer diagonal, and its rim.
constexpr const char* rhombus = R"(vertices
1 0 0 0
2 2 0.5 0
3 4 0 0
4 2 -0.5 0
edges
1 1 2
2 2 3
3 3 4
4 4 1
5 1 3
faces
1 -5 1 2
2 5 3 4
)";

TEST(Equiangulate, FlipsTheWorseDiagonal) {
  const Folder folder;
  Trial trial;
  trial.session().load(folder.write("film.fe", rhombus));
  trial.session().set_quiet(false);
  EXPECT_EQ(trial.out("u"), "Edges switched in equiangulation: 1\n");
  EXPECT_EQ(trial.number("equi_count"), 1);
  EXPECT_EQ(trial.number("edge[5].length"), 1);
  EXPECT_EQ(trial.number("total_area"), 2);
  // Ends early when nothing is left.
  EXPECT_EQ(trial.out("u 5"), "Edges switched in equiangulation: 0\n");
  EXPECT_EQ(trial.out("equiangulate 0"), "");
}

// As many flips as Surface Evolver 2.70 makes after `r; g 5; l 0.3`.
TEST(Equiangulate, FlipsWhatEvolverFlips) {
  const std::pair<const char*, double> flips[] = {
      {"cube.fe", 48}, {"double_bubble.fe", 72}, {"catenoid.fe", 192}, {"wire_cube.fe", 64}};
  for (const auto& [file, count] : flips) {
    Trial trial(file);
    trial.out("r; g 5; l 0.3; u");
    EXPECT_EQ(trial.number("equi_count"), count) << file;
    trial.out("u");
    EXPECT_EQ(trial.number("equi_count"), 0) << file;
  }
}

TEST(Equiangulate, LeavesWhatIsFixed) {
  const Folder folder;
  for (const char* fixed : {"fix edge[5]", "fix facet[2]", "set facet[1] tension 2"}) {
    Trial trial;
    trial.session().load(folder.write("film.fe", rhombus));
    trial.out(std::string(fixed) + "; u");
    EXPECT_EQ(trial.number("equi_count"), 0) << fixed;
  }
}

TEST(Equiangulate, KeepsTheFilmAndItsVolumes) {
  Trial trial("double_bubble.fe");
  trial.out("refine; relax 3; refine edges where length > 0.3");
  trial.out("u 10; check");
  EXPECT_EQ(trial.number("equi_count"), 0);
  EXPECT_EQ(trial.number("facet_count - edge_count + vertex_count"), 3);
}

TEST(Equiangulate, Refuses) {
  Trial trial("cube.fe");
  EXPECT_TRUE(contains(trial.failure("u -1"), "test:1:3: error: times must be at least 0, not -1"));
  EXPECT_TRUE(contains(Trial().failure("u"), "there is no film to equiangulate"));
}

}  // namespace
}  // namespace lamella::trial
