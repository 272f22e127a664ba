#include "support/trial.h"

namespace lamella::trial {
namespace {

// Two hexagonal cones tip to tip come apart, and relax to two discs.
TEST(PopVertices, ConesTipToTipComeApart) {
  const Folder folder;
  std::string text = "vertices\n1 0 0 0\n";
  for (int ring = 0; ring < 2; ++ring) {
    for (int i = 0; i < 6; ++i) {
      const double a = M_PI * i / 3;
      text += fmt::format("{} {} {} {} fixed\n", 2 + 6 * ring + i, std::cos(a), std::sin(a),
                          ring == 0 ? 0.2 : -0.2);
    }
  }
  text += "edges\n";
  for (int i = 0; i < 12; ++i) text += fmt::format("{} 1 {}\n", i + 1, i + 2);
  for (int ring = 0; ring < 2; ++ring) {
    for (int i = 0; i < 6; ++i)
      text +=
          fmt::format("{} {} {} fixed\n", 13 + 6 * ring + i, 2 + 6 * ring + i, 2 + 6 * ring + (i + 1) % 6);
  }
  text += "faces\n";
  for (int ring = 0; ring < 2; ++ring) {
    for (int i = 0; i < 6; ++i) {
      const int k = 6 * ring + i;
      text += fmt::format("{} {} {} -{}\n", k + 1, k + 1, 13 + k, 6 * ring + (i + 1) % 6 + 1);
    }
  }
  Trial trial;
  trial.out("load \"" + folder.write("cones.fe", text) + "\"");
  trial.out("o; check");
  EXPECT_EQ(trial.number("vertex_pop_count"), 1);
  EXPECT_EQ(trial.number("vertex_count"), 14);
  trial.out("relax");
  EXPECT_NEAR(trial.number("total_area"), 2 * 1.5 * std::sqrt(3.0), 1e-9);
}

TEST(PopVertices, NeedsAFilm) {
  Trial trial;
  EXPECT_TRUE(contains(trial.failure("o"), "there is no film to pop"));
}

}  // namespace
}  // namespace lamella::trial
