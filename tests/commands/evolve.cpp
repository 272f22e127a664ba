#include <cmath>

#include "support/trial.h"

namespace lamella::trial {
namespace {

TEST(Evolve, KeepsVolumesThroughEveryStep) {
  Trial trial("double_bubble.fe");
  trial.out("refine 2");
  for (int i = 0; i < 20; ++i) {
    trial.out("evolve 10");
    EXPECT_NEAR(trial.number("body[1].volume"), 1, 2e-12) << i;
    EXPECT_NEAR(trial.number("body[2].volume"), 1, 2e-12) << i;
  }
}

// With damping the film comes to rest where relax brings it.
TEST(Evolve, DampedItComesToRest) {
  Trial trial("cube.fe");
  trial.out("refine 2; damping := 4; evolve 600");
  const double evolved = trial.number("total_area");
  trial.out("relax motion normal keep_mesh");
  EXPECT_NEAR(evolved, trial.number("total_area"), 5e-3);
}

TEST(Evolve, TimeAndRow) {
  Trial trial("cube.fe");
  trial.session().set_quiet(false);
  trial.out("refine 2");
  EXPECT_TRUE(trial.out("evolve 5 dt 0.01").starts_with("time 0.05: energy "));
  EXPECT_NEAR(trial.number("total_time"), 0.05, 1e-15);
  EXPECT_TRUE(trial.out("evolve 1 dt auto").ends_with("\n"));
  EXPECT_TRUE(contains(trial.out("evolve 1 dt=0.01"), ", 1 step of 0.01 to 0.01\n"));
  // Above the bound a step is made in parts, and takes as much time.
  const double time = trial.number("total_time");
  const std::string told = trial.out("evolve 2 dt 0.5");
  EXPECT_TRUE(contains(told, "dt 0.5 is too long for stability (bound ")) << told;
  EXPECT_TRUE(contains(told, "): 2 steps made in ")) << told;
  EXPECT_NEAR(trial.number("total_time"), time + 1, 1e-12);
}

// Velocities belong to the film, and so does where its forces were taken: two halves make the whole.
TEST(Evolve, GoesOnWhereItStopped) {
  Trial whole("double_bubble.fe");
  whole.out("refine 2; evolve 20 dt 0.005");
  Trial halves("double_bubble.fe");
  halves.out("refine 2; evolve 10 dt 0.005; evolve 10 dt 0.005");
  for (const char* value : {"total_area", "kinetic_energy", "sum(vertices, x*id)"})
    EXPECT_EQ(whole.number(value), halves.number(value)) << value;
}

// But not where somebody has put the film elsewhere.
TEST(Evolve, GoesOnFromWhereTheFilmIs) {
  Trial trial("double_bubble.fe");
  trial.out("refine 2; evolve 10 dt 0.005");
  const double before = trial.number("sum(vertices, x)");
  trial.out("foreach vertex vv do vv.x := vv.x + 1; evolve 1 dt 1e-9");
  EXPECT_NEAR(trial.number("sum(vertices, x)"), before + trial.number("vertex_count"), 1e-5);
}

TEST(Evolve, FixedVerticesStay) {
  Trial trial("catenoid.fe");
  const std::string held =
      "foreach vertex vv where vv.fixed do printf \"%d %.17g %.17g %.17g\\n\", vv.id, vv.x, vv.y, vv.z";
  const std::string before = trial.out("refine; " + held);
  EXPECT_TRUE(trial.out("evolve 20; " + held) == before);
}

TEST(Evolve, Refuses) {
  Trial trial("double_bubble.fe");
  EXPECT_TRUE(contains(trial.failure("evolve -1"), "test:1:8: error: steps must be at least 0, not -1"));
  EXPECT_TRUE(
      contains(trial.failure("evolve 10 dt 0"), "test:1:14: error: dt must be greater than 0, not 0"));
  EXPECT_TRUE(contains(trial.failure("evolve dt nan"), "\"nan\" is not defined"));
  EXPECT_TRUE(contains(trial.failure("evolve dt"), "dt needs its value"));
  EXPECT_TRUE(contains(trial.failure("evolve 1 dt 1e300"), "dt is too large: 1e+300"));
  EXPECT_TRUE(contains(trial.failure("evolve 1 dt 1e-300"), "dt is too small: 1e-300"));
  EXPECT_TRUE(contains(trial.failure("{ fix vertex; body[1].target := 3; evolve }"),
                       "cannot be brought to their targets"));
  EXPECT_TRUE(contains(Trial().failure("evolve"), "there is no film to move"));
  EXPECT_EQ(trial.number("total_time"), 0);
}

// --- ways to keep volumes, and methods

TEST(Evolve, KeepsVolumesAtJunctionsInEveryWay) {
  for (const char* way : {"auto", "lagged", "exact", "paper"}) {
    Trial trial("double_bubble.fe");
    trial.out(std::string("refine 2; relax; kick (0.1*x, 0.1*y, -0.2*z); evolve 60 volumes=") + way);
    const double most = way == std::string("paper") ? 1e-4 : way == std::string("lagged") ? 1e-5 : 1e-10;
    EXPECT_NEAR(trial.number("body[1].volume"), 1, most) << way;
    EXPECT_NEAR(trial.number("body[2].volume"), 1, most) << way;
  }
}

TEST(Evolve, ImplicitMethodsTakeLongSteps) {
  for (const char* method : {"implicit", "midpoint"}) {
    Trial trial("double_bubble.fe");
    trial.out(std::string("refine 2; relax; kick (0.1*x, 0.1*y, -0.2*z); evolve 8 dt 0.3 method=") + method);
    EXPECT_NEAR(trial.number("total_time"), 2.4, 1e-12);
    EXPECT_NEAR(trial.number("body[1].volume"), 1, 1e-10) << method;
  }
}

// Films without bodies have no volumes to keep, in any method.
TEST(Evolve, EveryMethodMovesFilmsWithoutBodies) {
  for (const char* method : {"euler", "verlet", "gradient", "implicit", "midpoint"}) {
    for (const char* file : {"wire_cube.fe", "moving_rings.fe"}) {
      Trial trial(file);
      const double before = trial.number("total_energy");
      trial.out(std::string("refine 2; evolve 20 dt 0.0002 method=") + method);
      EXPECT_NEAR(trial.number("total_time"), 0.004, 1e-12) << method;
      EXPECT_NEAR(trial.number("total_energy + kinetic_energy"), before, 0.05 * before) << method << file;
    }
  }
}

// --- wires that move

TEST(Evolve, RingsThatArePulledApartCarryTheirVertices) {
  Trial trial("moving_rings.fe");
  trial.out("refine 2; relax; damping := 1; speed := 0.04; start := total_time; evolve 50 dt 0.01");
  EXPECT_NEAR(trial.number("max(vertices, z)"), 0.28 + 0.04 * 0.5, 1e-12);
  EXPECT_NEAR(trial.number("max(vertices where fixed, abs(abs(velocity[3]) - 0.04))"), 0, 1e-9);
  EXPECT_NEAR(trial.number("max(vertices where fixed, abs(velocity[1]))"), 0, 1e-9);
  // The film between follows, slower towards the middle.
  EXPECT_LT(trial.number("max(vertices where abs(z) < 0.05, abs(velocity[3]))"), 0.02);
}

TEST(Evolve, AFrameThatTwistsCarriesItsVertices) {
  Trial trial("twisting_frame.fe");
  trial.out("refine 3; turning := 0.5; evolve 100 dt 0.005");
  // The corner at p = (1, 1) turns at 0.5: |velocity| = 0.5, square to its arm. Velocities are those half a
  // step ago.
  EXPECT_NEAR(trial.number("vertex[3].velocity[2]"), -0.5 * std::sin(0.5 * 0.4975), 1e-6);
  EXPECT_NEAR(trial.number("vertex[3].velocity[3]"), 0.5 * std::cos(0.5 * 0.4975), 1e-6);
  EXPECT_EQ(trial.number("vertex[1].velocity[3]^2 + vertex[1].velocity[2]^2"), 0);
}

TEST(Evolve, ARingThatIsSweptDragsItsFilmBehind) {
  Trial trial("swept_ring.fe");
  trial.out("refine 3; evolve 100 dt 0.005");
  EXPECT_NEAR(trial.number("max(vertices where fixed, abs(velocity[3] - 1))"), 0, 1e-9);
  EXPECT_NEAR(trial.number("min(vertices where fixed, z)"), 0.5, 1e-12);
  EXPECT_LT(trial.number("min(vertices, z)"), 0.3);
}

// A level set that rises carries vertices along its normal and leaves them free to slide.
TEST(Evolve, ATableThatRisesCarriesTheDrop) {
  Trial trial;
  const Folder folder;
  std::string drop = file_content(datafile("drop_on_table.fe"));
  trial.out("load \"" + datafile("drop_on_table.fe") + "\"; refine 2; relax; save \"" + (folder / "a.fe") +
            "\"");
  drop = file_content(folder / "a.fe");
  const std::size_t formula = drop.find("formula:");
  const std::size_t end = drop.find('\n', formula);
  const std::string table = drop.substr(formula + 8, end - formula - 8);
  drop.replace(formula, end - formula,
               "formula: " + table + (table.find('=') == std::string::npos ? "" : " + ") + " 0.2*total_time");
  trial.out("load \"" + folder.write("b.fe", drop) + "\"; evolve 50 dt 0.004");
  EXPECT_NEAR(trial.number("min(vertices, z)"), 0.2 * 0.2, 1e-10);
  EXPECT_NEAR(trial.number("max(vertices where z < 0.0401, abs(velocity[3] - 0.2))"), 0, 1e-8);
}

// Beyond 1.325 radii no film hangs between the rings: the neck closes, and where the topology is kept evolve
// does not go on for ever.
TEST(Evolve, StopsWhereANeckPinches) {
  Trial trial("moving_rings.fe");
  trial.out("topology off; refine 2; relax; damping := 1; speed := 0.04; start := total_time");
  const Ran ran = trial.run("evolve 500 dt 0.01");
  EXPECT_EQ(ran.outcome, session::Outcome::done);
  EXPECT_TRUE(contains(ran.messages, "facets shrink to nothing")) << ran.messages;
  EXPECT_LT(trial.number("min(vertices where not fixed, sqrt(x^2+y^2))"), 0.02);
  EXPECT_LT(trial.number("total_time"), 4.9);
}

}  // namespace
}  // namespace lamella::trial
