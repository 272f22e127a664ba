// Films on constraints and boundaries, as commands meet them; numbers are Surface Evolver's for the same
// files.
#include "support/trial.h"

namespace lamella::trial {
namespace {

struct Refined {
  const char* file;
  double energy;
  double area;
};

// New vertices inherit what holds their edges, and lie where Evolver puts them.
TEST(HeldFilms, RefinedEnergiesAreEvolvers) {
  const Refined cases[] = {
      {"tricky/constraint_integrals.fe", 1.2921817970919525, 1.3825373456924455},
      {"tricky/boundaries.fe", 5.8198199830719792, 5.7342451382660267},
      {"tricky/constraints.fe", 4.47113321379606, 4.47113321379606},
      {"tricky/constraints_of_a_dump.fe", 2.8660254037844384, 1.3660254037844386},
      {"catenoid_on_rings.fe", 8.0103860246459888, 8.0103860246459888},
      {"drop_on_table.fe", 5, 5},
  };
  for (const Refined& wanted : cases) {
    SCOPED_TRACE(wanted.file);
    Trial trial(wanted.file);
    trial.out("refine 2");
    EXPECT_NEAR(trial.number("total_energy"), wanted.energy, 1e-12 * wanted.energy);
    EXPECT_NEAR(trial.number("total_area"), wanted.area, 1e-12 * wanted.area);
  }
}

TEST(HeldFilms, QuantitiesAreEvolvers) {
  Trial trial("tricky/quantities.fe");
  const std::pair<const char*, double> values[] = {
      {"whole.value", -0.325724999999998},
      {"half.value", -0.162862499999999},
      {"corners.value", 1.15},
      {"wires.value", 1.29931239990603},
      {"along.value", -1.86},
      {"heavy.value", 0.159935035352419},
      {"tense.value", 3.8982526806662},
      {"under.value", 0.1},
      {"dense.value", 2.21756039354834},
      {"around.value", 3.43356885596417},
      {"bent.value", 4.19524469601048},
  };
  for (const auto& [name, value] : values)
    EXPECT_NEAR(trial.number(name), value, 1e-13 * (1 + std::abs(value))) << name;
  EXPECT_NEAR(trial.number("total_energy"), 10.072904365437161, 1e-12);
  trial.out("refine");
  EXPECT_NEAR(trial.number("total_energy"), 11.06790436543716, 1e-12);
  EXPECT_NEAR(trial.number("bent.value"), 8.21897513142554, 1e-12);
  EXPECT_NEAR(trial.number("tense.value"), 3.8982526806662, 1e-12);
  trial.out("corners.modulus := 0");
  EXPECT_NEAR(trial.number("total_energy"), 11.06790436543716 - 2.145, 1e-12);
  EXPECT_TRUE(contains(trial.failure("corners.value := 1"), "cannot be set"));
}

TEST(HeldFilms, ContentsCountInVolumes) {
  Trial trial("tricky/constraint_integrals.fe");
  EXPECT_NEAR(trial.number("body[1].volume"), 0.98144583175103195, 1e-12);
  trial.out("refine 2");
  EXPECT_NEAR(trial.number("body[1].volume"), 0.98514555160610895, 1e-12);
}

TEST(HeldFilms, ConstraintsAreAttributes) {
  Trial trial("tricky/constraints.fe");
  EXPECT_EQ(trial.number("count(vertex where on_constraint 1)"), 2);
  EXPECT_EQ(trial.number("count(vertex where on_constraint ground and not fixed)"), 1);
  EXPECT_EQ(trial.number("count(vertex where on_constraint 7)"), 5);
  EXPECT_EQ(trial.number("count(facet where on_constraint ground)"), 1);
  EXPECT_EQ(trial.number("vertex[3].hit_constraint ground"), 1);
  EXPECT_EQ(trial.number("vertex[2].hit_constraint ground"), 0);
  EXPECT_NEAR(trial.number("vertex[1].value_of_constraint ground"), 2 / std::sqrt(3) - 0.5, 1e-14);
  trial.out("set vertex constraint 1 where id == 4");
  EXPECT_EQ(trial.number("vertex[4].on_constraint 1"), 1);
  EXPECT_NEAR(trial.number("vertex[4].x"), 2 / std::sqrt(3), 1e-14);
  trial.out("unset vertices constraint 1");
  EXPECT_EQ(trial.number("count(vertex where on_constraint 1)"), 0);
  trial.out("set edge[2] constraint ground; refine");
  EXPECT_EQ(trial.number("count(vertex where on_constraint ground)"), 3);
  EXPECT_TRUE(contains(trial.failure("set vertex[1] constraint 5"), "there is no constraint 5"));
  EXPECT_TRUE(contains(trial.failure("print vertex[1].value_of_constraint 9"), "there is no constraint 9"));
}

TEST(HeldFilms, BoundariesAreAttributes) {
  Trial trial("tricky/boundaries.fe");
  EXPECT_EQ(trial.number("count(vertex where on_boundary 1)"), 3);
  EXPECT_EQ(trial.number("count(edge where on_boundary dish)"), 1);
  EXPECT_EQ(trial.number("vertex[2].p1"), 1);
  EXPECT_EQ(trial.number("vertex[5].p2"), -0.75);
  EXPECT_EQ(trial.number("vertex[6].v_boundary"), 0);
  trial.out("set vertex[2].p1 pi/2");
  EXPECT_NEAR(trial.number("vertex[2].y"), 0.7, 1e-15);
  trial.out("unset vertex boundary 1; unset edges boundary 1");
  EXPECT_EQ(trial.number("count(vertex where on_boundary 1)"), 0);
  EXPECT_TRUE(contains(trial.failure("set vertex[6].p1 1"), "on no boundary"));
}

// What is saved is the same film, held the same way.
TEST(HeldFilms, AreSavedAndLoaded) {
  for (const char* file : {"tricky/constraint_integrals.fe", "tricky/boundaries.fe", "tricky/constraints.fe",
                           "tricky/quantities.fe"}) {
    SCOPED_TRACE(file);
    const Folder folder;
    Trial trial(file);
    trial.out("refine");
    const double energy = trial.number("total_energy");
    trial.out("save \"" + folder / "saved.fe" + "\"; refine");
    const double refined = trial.number("total_energy");
    trial.out("load \"" + folder / "saved.fe" + "\"");
    EXPECT_NEAR(trial.number("total_energy"), energy, 1e-13 * energy);
    trial.out("refine");
    EXPECT_NEAR(trial.number("total_energy"), refined, 1e-13 * refined);
  }
}

}  // namespace
}  // namespace lamella::trial
