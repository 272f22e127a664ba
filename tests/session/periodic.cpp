// Periodic films in use: refined, mended, relaxed, saved, drawn.
#include "datafile/read.h"
#include "support/trial.h"

namespace lamella::session {
namespace {

TEST(PeriodicFoam, KelvinsRelaxesToItsMinimum) {
  trial::Trial trial("kelvin.fe");
  trial.out("refine; refine; refine; relax");
  EXPECT_EQ(trial.number("converged"), 1);
  EXPECT_EQ(trial.number("stable"), 1);
  // 3.34274443, and the error of facets that are flat
  EXPECT_NEAR(trial.number("total_area"), 3.34284829, 1e-7);
  EXPECT_NEAR(trial.number("body[1].volume"), 0.5, 1e-12);
}

TEST(PeriodicFoam, StaysSoundThroughSurgery) {
  trial::Trial trial("weaire_phelan.fe");
  const double area = trial.number("total_area");
  trial.out("refine");
  EXPECT_NEAR(trial.number("total_area"), area, 1e-12);
  trial.out("refine edges where id % 7 == 3; refine facets where id % 11 == 1; long_edges 0.3; check");
  EXPECT_NEAR(trial.number("total_area"), area, 1e-12);
  EXPECT_NEAR(trial.number("body[3].volume"), 1.0078125, 1e-12);
  trial.out("g 3; u; V; u; tiny_edges 0.12; V; check; g 5");
  EXPECT_NEAR(trial.number("body[3].volume"), 1, 1e-10);
  EXPECT_LT(trial.number("total_area"), 21.17);
}

TEST(PeriodicFoam, IsSavedAsItIs) {
  const trial::Folder folder;
  trial::Trial trial("kelvin.fe");
  trial.out("refine; g 2; save \"" + folder / "saved.fe" + "\"");
  trial::Trial again;
  again.out("load \"" + folder / "saved.fe" + "\"");
  EXPECT_EQ(again.number("total_area"), trial.number("total_area"));
  EXPECT_NEAR(again.number("body[2].volume"), 0.5, 1e-13);
  EXPECT_NE(trial::file_content(folder / "saved.fe").find("torus_filled\nperiods\n1 0 0\n"),
            std::string::npos);
}

TEST(PeriodicFoam, MovesWithItsMomentum) {
  trial::Trial trial("kelvin.fe");
  trial.out("refine; refine; set vertex velocity[1] 0.1*sin(2*pi*x); evolve 50");
  EXPECT_NEAR(trial.number("body[1].volume"), 0.5, 1e-9);
  EXPECT_LT(trial.number("total_area"), 3.36);
}

TEST(PeriodicFoam, IsDrawnWithEveryBubbleWhole) {
  const trial::Folder folder;
  trial::Trial trial("kelvin.fe");
  trial.out("refine; show \"" + folder / "kelvin.png" + "\" size=120x90");
  EXPECT_GT(trial::file_content(folder / "kelvin.png").size(), 1000U);
}

TEST(PeriodicFoam, FacesHaveToClose) {
  try {
    datafile::read_datafile(text::make_source("t", R"(torus
vertices
1 0 0 0
2 0.5 0 0
3 0 0.5 0
edges
1 1 2 * * *
2 2 3 * + *
3 3 1 * * *
faces
1 1 2 3
)"));
    FAIL();
  } catch (const text::Error& error) {
    EXPECT_NE(std::string(error.what()).find("face 1 does not close"), std::string::npos)
        << std::string(error.what());
  }
}

}  // namespace
}  // namespace lamella::session
