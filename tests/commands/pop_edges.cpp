#include "support/trial.h"

namespace lamella::trial {
namespace {

// Four half planes meet in a line, 60 and 120 degrees apart: the line divides in two, with a film between.
TEST(PopEdges, FourFilmsBecomeFive) {
  const Folder folder;
  std::string text = "vertices\n";
  const double angles[] = {0, 60, 180, 240};
  for (int z = 0; z < 3; ++z) {
    text += fmt::format("{} 0 0 {} {}\n", 1 + 5 * z, z - 1, z == 1 ? "" : "fixed");
    for (int i = 0; i < 4; ++i) {
      const double a = angles[i] * M_PI / 180;
      text += fmt::format("{} {} {} {} fixed\n", 2 + 5 * z + i, std::cos(a), std::sin(a), z - 1);
    }
  }
  text += "edges\n1 1 6\n2 6 11\n";
  for (int z = 0; z < 3; ++z) {
    for (int i = 0; i < 4; ++i) text += fmt::format("{} {} {}\n", 3 + 4 * z + i, 1 + 5 * z, 2 + 5 * z + i);
  }
  for (int z = 0; z < 2; ++z) {
    for (int i = 0; i < 4; ++i)
      text += fmt::format("{} {} {} fixed\n", 15 + 4 * z + i, 2 + 5 * z + i, 7 + 5 * z + i);
  }
  text += "faces\n";
  for (int z = 0; z < 2; ++z) {
    for (int i = 0; i < 4; ++i)
      text += fmt::format("{} {} {} -{} -{}\n", 1 + 4 * z + i, 3 + 4 * z + i, 15 + 4 * z + i, 7 + 4 * z + i,
                          1 + z);
  }
  Trial trial;
  trial.out("load \"" + folder.write("lines.fe", text) + "\"");
  EXPECT_EQ(trial.number("count(edge where valence == 4)"), 2);
  trial.out("O; check");
  EXPECT_EQ(trial.number("edge_pop_count"), 2);
  EXPECT_EQ(trial.number("count(edge where valence == 4)"), 0);
  EXPECT_GE(trial.number("count(edge where valence == 3)"), 4);
}

TEST(PopEdges, NeedsAFilm) {
  Trial trial;
  EXPECT_TRUE(contains(trial.failure("O"), "there is no film to pop"));
}

}  // namespace
}  // namespace lamella::trial
