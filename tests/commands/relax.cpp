#include <cmath>

#include "support/trial.h"

namespace lamella::trial {
namespace {

constexpr double sphere = 4.835975862049;  // area around volume 1

TEST(Relax, DoubleBubble) {
  Trial trial("double_bubble.fe");
  trial.out("refine; refine; relax");
  EXPECT_NEAR(trial.number("total_area"), 9.158, 5e-4);
  EXPECT_LT(trial.number("triple_angle_rms"), 2.2);
  EXPECT_NEAR(trial.number("body[1].volume"), 1, 1e-12);
  EXPECT_NEAR(trial.number("body[2].volume"), 1, 1e-12);
  EXPECT_NEAR(trial.number("body[1].pressure"), trial.number("body[2].pressure"), 1e-3);
  EXPECT_EQ(trial.number("relax_converged"), 1);
  EXPECT_LT(trial.number("relax_residual"), 1e-10);
}

// Errors fall fourfold with each refinement.
TEST(Relax, TheCubeTendsToTheSphereAtSecondOrder) {
  Trial trial("cube.fe");
  trial.out("refine");
  double before = 0;
  for (int level = 2; level <= 5; ++level) {
    trial.out("refine; relax");
    const double error = trial.number("total_area") - sphere;
    EXPECT_GT(error, 0);
    if (before > 0) {
      EXPECT_NEAR(std::log2(before / error), 2, 0.25) << level;
    }
    before = error;
  }
  EXPECT_LT(before, 8e-3);
}

TEST(Relax, TheWireCubeTendsToItsThirteenFilms) {
  Trial trial("wire_cube.fe");
  trial.out("refine 3; relax");
  const double coarse = trial.number("total_area") - 4.23956311;
  trial.out("refine; relax");
  const double fine = trial.number("total_area") - 4.23956311;
  EXPECT_GT(fine, -1e-6);
  EXPECT_LT(std::abs(fine), 0.5 * std::abs(coarse) + 1e-6);
  EXPECT_LT(fine, 2e-3);
}

TEST(Relax, TellsHowItEnded) {
  Trial trial("cube.fe");
  trial.session().set_quiet(false);
  trial.out("refine 2");
  EXPECT_TRUE(trial.out("relax 3").starts_with("step limit reached after 3 iterations: energy "));
  EXPECT_EQ(trial.number("relax_converged"), 0);
  EXPECT_TRUE(trial.out("relax").starts_with("converged after "));
  EXPECT_TRUE(trial.out("relax 0").starts_with("step limit reached after 0 iterations"));
}

TEST(Relax, Options) {
  Trial trial("cube.fe");
  trial.out("refine 3");
  const double start = trial.number("total_area");
  for (const char* line :
       {"relax 30 method descent", "relax motion full keep_mesh", "relax motion normal keep_mesh",
        "relax keep_mesh", "relax tolerance 1e-6", "relax method lbfgs tolerance=1e-4", "relax 60 method cg",
        "relax method=newton"}) {
    trial.out(line);
    EXPECT_LT(trial.number("total_area"), 0.9 * start) << line;
    EXPECT_NEAR(trial.number("body[1].volume"), 1, 1e-12) << line;
    EXPECT_EQ(trial.number("edge[1].valence"), 2);
    trial.out("undo");
  }
}

// Without flips the connectivity stays.
TEST(Relax, KeepMeshKeepsTheMesh) {
  Trial trial("double_bubble.fe");
  const char* edges = "foreach edge ee do printf \"%d %d\\n\", ee.vertex[1].id, ee.vertex[2].id";
  const std::string before = trial.out(std::string("refine 2; ") + edges);
  EXPECT_EQ(trial.out(std::string("relax keep_mesh; ") + edges), before);
}

TEST(Relax, FreeFilmsAndWires) {
  const Folder folder;
  const std::string wire = folder.write("wire.fe",
                                        "vertices\n1 0 0 0 fixed\n2 1 1 0\n3 2 0 0 fixed\n"
                                        "edges\n1 1 2 tension 1 bare\n2 2 3 tension 1 bare\n");
  Trial trial;
  trial.session().load(wire);
  trial.out("relax");
  EXPECT_NEAR(trial.number("vertex[2].y"), 0, 1e-4);
  EXPECT_NEAR(trial.number("total_energy"), 2, 1e-9);
  // Nothing pulls here, so all is at rest.
  trial.out("unset edge tension; set vertex[2] y 1; relax");
  EXPECT_EQ(trial.number("relax_converged"), 1);
  EXPECT_EQ(trial.number("vertex[2].y"), 1);
  // A film that nothing holds shrinks to a point.
  trial.session().load(folder.write("free.fe",
                                    "vertices\n1 0 0 0\n2 1 0 0\n3 0 1 0\n"
                                    "edges\n1 1 2\n2 2 3\n3 3 1\nfaces\n1 1 2 3\n"));
  trial.out("relax");
  EXPECT_LT(trial.number("total_area"), 1e-12);
}

TEST(Relax, WhatCannotMoveIsAtRest) {
  for (const char* file : {"tricky/only_vertices.fe", "cube.fe"}) {
    Trial trial(file);
    trial.out("fix vertex; vc off; relax");
    EXPECT_EQ(trial.number("relax_converged"), 1) << file;
  }
}

TEST(Relax, TellsWhatItKnows) {
  Trial trial("double_bubble.fe");
  trial.session().set_quiet(false);
  const std::string told = trial.out("refine 2; relax");
  EXPECT_TRUE(contains(told, "\nstable; smallest angle "));
  EXPECT_EQ(trial.number("converged"), 1);
  EXPECT_EQ(trial.number("stable"), 1);
  EXPECT_EQ(trial.number("negative_modes"), 0);
  EXPECT_LT(trial.number("residual"), 1e-10);
  trial.out("relax 2 tolerance 1e-3");
  EXPECT_EQ(trial.number("stable"), 0);  // not looked at
}

// The last digits are Newton's: two or three steps after a dozen iterations of descent, whatever the mesh.
TEST(Relax, NeedsNoMoreIterationsOnAFinerMesh) {
  for (const char* file : {"cube.fe", "double_bubble.fe", "wire_cube.fe", "catenoid.fe"}) {
    Trial trial(file);
    trial.session().set_quiet(false);
    for (const char* line : {"refine 2; relax", "refine 2; relax"}) {
      const std::string told = trial.out(line);
      const std::size_t at = told.find("converged after ");
      ASSERT_NE(at, std::string::npos) << file << told;
      EXPECT_LE(std::stoi(told.substr(at + 16)), 40) << file;
      EXPECT_GT(trial.number("min(facet,area)"), 0);
    }
  }
}

TEST(Relax, Levels) {
  Trial trial("cube.fe");
  trial.session().set_quiet(false);
  const std::string told = trial.out("relax levels=4");
  EXPECT_TRUE(contains(told, "     6144 facets: energy 4.836"));
  EXPECT_TRUE(contains(told, "extrapolated energy 4.8359"));
  EXPECT_NEAR(trial.number("relax_limit"), sphere, 2e-5);
  EXPECT_NEAR(trial.number("relax_estimate"), trial.number("total_energy") / sphere - 1, 2e-5);
  EXPECT_EQ(trial.number("stable"), 1);
}

// Slopes of log error over log facets, fitted through three levels: one, which is second order in length.
TEST(Relax, EnergiesConvergeAtSecondOrder) {
  struct Known {
    const char* file;
    double exact;
  };
  // The catenoid's rings are polygons; its limit is by extrapolation from 786k facets.
  for (const Known& known : {Known{"cube.fe", sphere},
                             {"double_bubble.fe", 9.139421678069},
                             {"wire_cube.fe", 4.23956311},
                             {"catenoid.fe", 7.60497}}) {
    Trial trial(known.file);
    trial.out("relax levels=2");
    double x = 0, y = 0, xx = 0, xy = 0;
    for (int level = 0; level < 3; ++level) {
      if (level > 0) trial.out("relax levels=1");
      const double facets = std::log(trial.number("facet_count"));
      const double error = std::log(std::abs(trial.number("total_energy") / known.exact - 1));
      x += facets / 3;
      y += error / 3;
      xx += facets * facets / 3;
      xy += facets * error / 3;
    }
    EXPECT_NEAR((xy - x * y) / (xx - x * x), -1, 0.15) << known.file;
  }
}

TEST(Relax, ToAWantedAccuracy) {
  Trial trial("wire_cube.fe");
  trial.out("relax to=1e-4");
  EXPECT_LT(trial.number("relax_estimate"), 1e-4);
  EXPECT_LT(std::abs(trial.number("total_energy") / 4.23956311 - 1), 1e-4);
  EXPECT_NEAR(trial.number("relax_limit"), 4.23956311, 2e-4);
  Trial coarse("wire_cube.fe");
  coarse.session().set_quiet(false);
  EXPECT_TRUE(contains(coarse.out("relax to=1e-9 facets=20000"), "not as accurate as asked for"));
  EXPECT_LE(coarse.number("facet_count"), 20000);
}

// At equal facet count the error is below uniform refinement's, and at equal error the count: errors times
// facets, which uniform refinement keeps, are compared at the finest meshes.
TEST(Relax, AdaptiveMeshesAreBetterThanUniformOnes) {
  struct Known {
    const char* file;
    double exact;
    const char* levels;
    double at_most;  // of the uniform mesh's
  };
  for (const Known& known : {Known{"wire_cube.fe", 4.23956310, "levels=4", 0.9},
                             {"catenoid.fe", 7.6049687, "levels=4", 0.95},
                             {"double_bubble.fe", 9.139421678069, "levels=4", 0.97},
                             {"catenoid_on_rings.fe", 7.65181219888, "levels=5", 0.9},
                             {"twisted_wire.fe", 3.9940832, "levels=4", 0.9},
                             {"triple_bubble.fe", 13.128168244433, "levels=4", 0.9}}) {
    const auto cost = [&](Trial& trial) {
      return std::abs(trial.number("total_energy") / known.exact - 1) * trial.number("facet_count");
    };
    Trial uniform(known.file);
    uniform.out(std::string("relax ") + known.levels);
    Trial adaptive(known.file);
    adaptive.out("relax to=1e-9 facets=" +
                 std::to_string(2 * static_cast<int>(uniform.number("facet_count"))));
    EXPECT_EQ(adaptive.number("converged"), 1);
    EXPECT_LT(cost(adaptive), known.at_most * cost(uniform)) << known.file;
  }
}

// What relax to=... claims is so: estimates are above the true errors, and not far.
TEST(Relax, EstimatesAreHonest) {
  struct Known {
    const char* file;
    double exact;
  };
  for (const Known& known : {Known{"wire_cube.fe", 4.23956310},
                             {"catenoid.fe", 7.6049687},
                             {"double_bubble.fe", 9.139421678069},
                             {"catenoid_on_rings.fe", 7.65181219888},
                             {"twisted_wire.fe", 3.9940832},
                             {"triple_bubble.fe", 13.128168244433}}) {
    for (const char* wanted : {"1e-3", "1e-4"}) {
      Trial trial(known.file);
      trial.out(std::string("relax to=") + wanted);
      const double error = std::abs(trial.number("total_energy") / known.exact - 1);
      EXPECT_LT(error, trial.number("relax_estimate")) << known.file;
      EXPECT_LT(trial.number("relax_estimate"), 3 * error) << known.file;
      EXPECT_LT(std::abs(trial.number("relax_limit") / known.exact - 1), 0.7 * error) << known.file << wanted;
    }
  }
}

TEST(Relax, LeavesNoSmallAngles) {
  for (const char* file : {"cube.fe", "double_bubble.fe", "triple_bubble.fe", "six_bubbles.fe", "catenoid.fe",
                           "catenoid_on_rings.fe", "drop_on_table.fe", "lattice.fe", "moving_rings.fe",
                           "kelvin.fe", "weaire_phelan.fe", "tetrahedral_frame.fe", "twisted_wire.fe",
                           "wire_cube.fe", "difficult/slivers.fe", "difficult/two_caps.fe"}) {
    Trial trial(file);
    trial.session().set_quiet(false);
    for (const char* levels : {"1", "1", "2"}) {
      const std::string told = trial.out(std::string("relax levels=") + levels);
      const std::size_t at = told.find("smallest angle ");
      ASSERT_NE(at, std::string::npos) << file;
      EXPECT_GT(std::stod(told.substr(at + 15)), 20) << file;
    }
  }
}

TEST(Relax, Refuses) {
  Trial trial("cube.fe");
  EXPECT_TRUE(contains(trial.failure("relax -1"), "test:1:7: error: steps must be at least 0, not -1"));
  EXPECT_TRUE(
      contains(trial.failure("relax tolerance 0"), "test:1:17: error: tolerance must be greater than 0"));
  EXPECT_TRUE(contains(trial.failure("relax method euler"),
                       "method is one of descent, cg, lbfgs, newton, not \"euler\""));
  EXPECT_TRUE(contains(trial.failure("relax levels=2 to=1e-3"), "levels and to exclude each other"));
  EXPECT_TRUE(contains(trial.failure("relax levels=2 method=cg"), "all methods in turn"));
  EXPECT_TRUE(contains(trial.failure("relax motion sideways"), "motion is one of normal, full"));
  EXPECT_TRUE(contains(trial.failure("relax method descent motion full"),
                       "descent by gradients knows no kinds of motion"));
  EXPECT_TRUE(contains(trial.failure("relax keepmesh"), "did you mean \"keep_mesh\"?"));
  EXPECT_TRUE(contains(trial.failure("{ fix vertex; body[1].target := 2; relax }"),
                       "cannot be brought to their targets"));
  EXPECT_TRUE(contains(Trial().failure("relax"), "there is no film to relax"));
  EXPECT_EQ(trial.number("total_area"), 6);
}

// Rings farther apart than a catenoid reaches: two discs, whose regular polygons of 24 sides have 12 sin(15)
// r^2 each.
TEST(RelaxTopology, PinchesWhereNoFilmReachesAcross) {
  Trial trial("rings_apart.fe");
  trial.out("start := 0.4; recalc; refine 3; relax topology; check");
  EXPECT_EQ(trial.number("relax_converged"), 1);
  EXPECT_EQ(trial.number("stable"), 1);
  EXPECT_NEAR(trial.number("total_area"), M_PI / 2, 5e-3);
  EXPECT_LT(trial.number("total_area"), M_PI / 2);  // inscribed
  // Nothing is left of the motion on the way.
  const Folder folder;
  trial.out("save \"" + folder / "after.fe" + "\"");
  const std::string file = file_content(folder / "after.fe");
  for (const char* trace :
       {"velocity", "mass", "mesh_size", "mesh_fitness", "steps_unkept", "swept", "defect"})
    EXPECT_FALSE(contains(file, trace)) << trace;
  EXPECT_EQ(trial.number("total_time"), 0);
}

TEST(RelaxTopology, LeavesWhatNoSoapFilmKeeps) {
  Trial trial("octahedral_cone.fe");
  trial.out("relax topology; check");
  EXPECT_EQ(trial.number("stable"), 1);
  EXPECT_NEAR(trial.number("total_area"), 4 * std::sqrt(2), 1e-10);
  Trial foam("four_bubbles.fe");
  foam.out("refine; o; relax topology; check");
  EXPECT_EQ(foam.number("stable"), 1);
  for (const char* body : {"body[1]", "body[2]", "body[3]", "body[4]"}) {
    const std::string b(body);
    EXPECT_NEAR(foam.number(b + ".volume") / foam.number(b + ".target"), 1, 1e-12) << b;
  }
}

TEST(RelaxTopology, IsRelaxWhereNothingIsToChange) {
  Trial plain("double_bubble.fe");
  Trial free("double_bubble.fe");
  plain.out("refine 2; damping := 0.5; relax");
  free.out("refine 2; damping := 0.5; relax topology");
  EXPECT_EQ(free.number("total_area"), plain.number("total_area"));
  EXPECT_EQ(free.number("damping"), 0.5);
  EXPECT_EQ(free.number("total_time"), 0);
}

TEST(RelaxTopology, RefusesWhatDoesNotGoWithIt) {
  Trial trial("cube.fe");
  EXPECT_TRUE(contains(trial.failure("relax topology levels=2"), "relax topology first"));
  EXPECT_TRUE(contains(trial.failure("relax topology method=cg"), "relax topology first"));
}

}  // namespace
}  // namespace lamella::trial
