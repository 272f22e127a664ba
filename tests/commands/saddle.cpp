#include "support/trial.h"

namespace lamella::trial {
namespace {

// A liquid column of 7 radii, past Rayleigh and Plateau's limit of 2 pi.
std::string long_column(const Folder& folder) {
  std::string text = file_content(datafile("difficult/column.fe"));
  const std::string before = "length = 6 ";
  text.replace(text.find(before), before.size(), "length = 7 ");
  return folder.write("column.fe", text);
}

TEST(Saddle, GoesDownFromOne) {
  const Folder folder;
  Trial trial;
  trial.session().load(long_column(folder));
  trial.session().set_quiet(false);
  EXPECT_TRUE(contains(trial.out("relax"), "saddle with 1 negative mode"));
  EXPECT_EQ(trial.number("converged"), 1);
  EXPECT_EQ(trial.number("stable"), 0);
  EXPECT_EQ(trial.number("negative_modes"), 1);
  const double energy = trial.number("total_energy");
  EXPECT_TRUE(contains(trial.out("saddle 0.1"), "Lowest eigenvalue -0.2"));
  EXPECT_LT(trial.number("total_energy"), energy);
  EXPECT_NEAR(trial.number("body[1].volume/body[1].target"), 1, 1e-12);
  const double after = trial.number("total_energy");
  trial.out("undo; saddle");
  EXPECT_LT(trial.number("total_energy"), after);
}

TEST(Saddle, LeavesAMinimumAlone) {
  Trial trial("cube.fe");
  trial.session().set_quiet(false);
  trial.out("refine 3; relax");
  const double energy = trial.number("total_energy");
  EXPECT_TRUE(contains(trial.out("saddle"), "Lowest eigenvalue 10."));
  EXPECT_EQ(trial.number("total_energy"), energy);
  EXPECT_TRUE(contains(trial.failure("saddle 0"), "limit must be greater than 0"));
}

}  // namespace
}  // namespace lamella::trial
