#include "support/trial.h"

namespace lamella::trial {
namespace {

TEST(Eigenprobe, CountsModes) {
  Trial trial("cube.fe");
  trial.out("refine 3; relax");
  // Three translations a little above 0, five modes near 10.4; one mode less than vertices, for the volume.
  EXPECT_EQ(trial.out("eigenprobe"), "Eigencounts:    0 <,  0 ==,  769 > \n");
  EXPECT_EQ(trial.out("eigenprobe 1"), "Eigencounts:    3 <,  0 ==,  766 > \n");
  EXPECT_EQ(trial.out("eigenprobe 15"), "Eigencounts:    8 <,  0 ==,  761 > \n");
  EXPECT_EQ(trial.out("eigen 1; eigenprobe last_eigenvalue").substr(0, 5), "  1. ");
  EXPECT_TRUE(contains(trial.out("eigenprobe last_eigenvalue*(1 - 1e-6)"), " 0 <,  0 ==,  769 >"));
}

}  // namespace
}  // namespace lamella::trial
