// The pull of a film on what holds it, where theory knows it.
#include <cmath>
#include <iterator>
#include <sstream>

#include "support/trial.h"

namespace lamella::trial {
namespace {

// The numbers of the row of that name: vertices, x, y, z, length.
std::vector<double> row(Trial& trial, const std::string& name) {
  std::istringstream lines(trial.out("reactions"));
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with(name + " ")) continue;
    std::istringstream numbers(line.substr(name.size()));
    return {std::istream_iterator<double>(numbers), {}};
  }
  ADD_FAILURE() << "no row " << name;
  return std::vector<double>(5);
}

// A catenoid r = c cosh(z/c) of tension 1 pulls on any ring around it with 2 pi c. Here c is 1.
TEST(Reactions, ACatenoidPullsOnBothRingsByItsWaist) {
  double before = 0;
  for (const int levels : {1, 2, 3}) {
    Trial trial("catenoid_on_rings.fe");
    trial.out("relax levels=" + std::to_string(levels));
    const std::vector<double> lower = row(trial, "boundary 1");
    const std::vector<double> upper = row(trial, "boundary 2");
    const std::vector<double> sum = row(trial, "all together");
    EXPECT_EQ(lower[0], 6 << levels);
    EXPECT_NEAR(lower[1], 0, 1e-4);
    EXPECT_NEAR(lower[3], -upper[3], 1e-4);
    EXPECT_GT(lower[3], 0);
    EXPECT_NEAR(sum[4], 0, 1e-4);
    const double error = std::abs(lower[3] / (2 * M_PI) - 1);
    EXPECT_LT(error, levels == 3 ? 0.01 : 0.2);
    if (levels > 1) {
      EXPECT_LT(error, before / 3);
    }
    before = error;
  }
}

TEST(Reactions, FilmsBetweenFixedWiresAreAtRestAsAWhole) {
  Trial trial("wire_cube.fe");
  trial.out("refine; relax");
  EXPECT_NEAR(row(trial, "all together")[4], 0, 1e-4);
  EXPECT_TRUE(contains(trial.out("reactions"), "wire at vertex 1 "));
}

// Half a sphere on a table: its film, upright there, pulls up with 2 pi r. (The air under it is no film.)
TEST(Reactions, ADropPullsOnItsTable) {
  Trial trial("drop_on_table.fe");
  trial.out("relax levels=4");
  EXPECT_TRUE(contains(trial.out("reactions"), "constraint 1 "));
  EXPECT_NEAR(row(trial, "constraint 1")[1], 0, 1e-4);
  EXPECT_NEAR(row(trial, "constraint 1")[2], 0, 1e-4);
  const double radius = std::cbrt(3 / (2 * M_PI));
  EXPECT_NEAR(row(trial, "constraint 1")[3], 2 * M_PI * radius, 0.01);
}

TEST(Reactions, NothingHoldsABubble) {
  EXPECT_EQ(Trial("cube.fe").out("reactions"), "nothing holds the film\n");
  EXPECT_TRUE(contains(Trial().failure("reactions all"), "reactions takes no arguments"));
}

}  // namespace
}  // namespace lamella::trial
