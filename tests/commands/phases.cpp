#include "support/trial.h"

namespace lamella::trial {
namespace {

// Two unit cubes side by side, of phases 2 and 3.
std::string two_cubes(const std::string& phasefile) {
  std::string text = "phasefile \"" + phasefile + "\"\nvertices\n";
  int id = 0;
  for (int x = 0; x < 3; ++x)
    for (int y = 0; y < 2; ++y)
      for (int z = 0; z < 2; ++z) text += fmt::format("{} {} {} {}\n", ++id, x, y, z);
  text += "edges\n";
  for (int x = 0; x < 3; ++x)
    text +=
        fmt::format("{} {} {}\n{} {} {}\n{} {} {}\n{} {} {}\n", 4 * x + 1, 4 * x + 1, 4 * x + 2, 4 * x + 2,
                    4 * x + 2, 4 * x + 4, 4 * x + 3, 4 * x + 4, 4 * x + 3, 4 * x + 4, 4 * x + 3, 4 * x + 1);
  for (int k = 0; k < 8; ++k) text += fmt::format("{} {} {}\n", 13 + k, 1 + k, 5 + k);
  return text + R"(faces
1 1 2 3 4
2 5 6 7 8
3 9 10 11 12
4 1 14 -5 -13
5 2 16 -6 -14
6 3 15 -7 -16
7 4 13 -8 -15
8 5 18 -9 -17
9 6 20 -10 -18
10 7 19 -11 -20
11 8 17 -12 -19
bodies
1 1 -4 -5 -6 -7 -2 phase 2
2 2 -8 -9 -10 -11 -3 phase 3
)";
}

TEST(Phases, DecideTheTensionBetweenBodies) {
  const Folder folder;
  folder.write("tensions", "3 phases\n1 2 1.5\nnothing in this line\n3 2 0.25\n");
  Trial trial;
  trial.out("load \"" + folder.write("cubes.fe", two_cubes("tensions")) + "\"");
  EXPECT_EQ(trial.number("facet_count"), 44);
  EXPECT_NEAR(trial.number("total_energy"), 10.25, 1e-14);  // Surface Evolver's value
  EXPECT_EQ(trial.number("body[2].phase"), 3);
  trial.out("save \"" + folder / "saved.fe" + "\"; load \"" + folder / "saved.fe" + "\"");
  EXPECT_NEAR(trial.number("total_energy"), 10.25, 1e-14);
  EXPECT_EQ(trial.number("body[1].phase"), 2);
}

TEST(Phases, AFileThatIsMissingOrWrongIsTold) {
  const Folder folder;
  Trial trial;
  const std::string scene = folder.write("cubes.fe", two_cubes("tensions"));
  EXPECT_TRUE(
      contains(trial.failure("load \"" + scene + "\""), "cubes.fe:1:11: error: cannot find the file"));
  folder.write("tensions", "3\n2 3 strong\n");
  EXPECT_TRUE(contains(trial.failure("load \"" + scene + "\""), "a line without a tension: 2 3 strong"));
}

}  // namespace
}  // namespace lamella::trial
