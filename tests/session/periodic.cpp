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

std::string kelvin_in(const std::string& periods) {
  std::string text = trial::file_content(trial::datafile("kelvin.fe"));
  const std::size_t at = text.find("torus_filled");
  EXPECT_NE(at, std::string::npos);
  const std::size_t end = text.find("vertices");
  return text.substr(0, at) + periods + "\n" + text.substr(end);
}

// The cell stretched, its volume kept: the film goes with it, and back.
TEST(PeriodicFoam, FollowsItsPeriods) {
  const trial::Folder folder;
  trial::Trial trial;
  trial.out("load \"" +
            folder.write("k.fe", kelvin_in("parameter stretch = 1\ntorus_filled\nperiods\nstretch 0 0\n"
                                           "0 1/stretch 0\n0 0 2 - 1\n")) +
            "\"");
  trial::Trial plain("kelvin.fe");
  EXPECT_EQ(trial.number("total_area"), plain.number("total_area"));
  trial.out("refine; refine; relax");
  const double least = trial.number("total_area");
  trial.out("save \"" + folder / "saved.fe" + "\"");
  trial.out("stretch := 1.1; relax");
  const double more = trial.number("total_area");
  EXPECT_GT(more, least + 1e-3);
  EXPECT_NEAR(trial.number("body[1].volume"), 0.5, 1e-11);
  trial.out("stretch := 1/1.1; relax");
  EXPECT_NEAR(trial.number("total_area"), more, 2e-5);  // the same with x and y exchanged
  trial.out("stretch := 1; relax");
  EXPECT_NEAR(trial.number("total_area"), least, 2e-5);

  const std::string saved = trial::file_content(folder / "saved.fe");
  EXPECT_NE(saved.find("periods\nstretch 0 0\n0 1/stretch 0\n0 0 (2 - 1)\n"), std::string::npos)
      << saved.substr(0, 400);
  trial::Trial again;
  again.out("load \"" + folder / "saved.fe" + "\"; stretch := 1.1; relax");
  EXPECT_NEAR(again.number("total_area"), more, 2e-5);
}

TEST(PeriodicFoam, WaitsForRecalcWhereItIsToldTo) {
  const trial::Folder folder;
  trial::Trial trial;
  trial.out("load \"" +
            folder.write("k.fe", kelvin_in("parameter a = 1\ntorus_filled\nperiods\na 0 0\n0 a 0\n0 0 a\n")) +
            "\"");
  const double area = trial.number("total_area");
  trial.out("autorecalc off; a := 1.25");
  EXPECT_EQ(trial.number("total_area"), area);
  trial.out("recalc");
  EXPECT_GT(trial.number("total_area"), area + 0.1);
  trial.out("undo; undo");
  EXPECT_EQ(trial.number("total_area"), area);
}

TEST(PeriodicFoam, RefusesPeriodsThatAreNone) {
  const trial::Folder folder;
  trial::Trial trial;
  trial.out(
      "load \"" +
      folder.write("k.fe", kelvin_in("parameter a = 1\ntorus_filled\nperiods\na 0 0\n0 a 0\n0 0 1/a\n")) +
      "\"");
  const double area = trial.number("total_area");
  EXPECT_TRUE(trial::contains(trial.failure("a := 0"), "a period is not a finite number: 1/a"));
  EXPECT_EQ(trial.number("a"), 1);
  EXPECT_EQ(trial.number("total_area"), area);
  EXPECT_TRUE(trial::contains(trial.failure("unfix a"), "cannot be optimized: periods name it"));
  for (const auto& [periods, message] :
       {std::pair("parameter a = 0\ntorus\nperiods\na 0 0\n0 1 0\n0 0 1\n", "the periods lie in a plane"),
        {"torus\nperiods\n1 total_time 0\n0 1 0\n0 0 1\n", "periods do not change with time"},
        {"torus\nperiods\nx 0 0\n0 1 0\n0 0 1\n", "\"x\" is not defined"},
        {"optimizing_parameter a = 1\ntorus\nperiods\na 0 0\n0 1 0\n0 0 1\n",
         "periods of optimizing parameters"}}) {
    const std::string said = trial.failure("load \"" + folder.write("k.fe", kelvin_in(periods)) + "\"");
    EXPECT_TRUE(trial::contains(said, message)) << said;
  }
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
