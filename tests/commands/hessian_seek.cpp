#include "support/trial.h"

namespace lamella::trial {
namespace {

// From any start the energy does not rise.
TEST(HessianSeek, NeverRaisesTheEnergy) {
  for (const char* file : {"cube.fe", "double_bubble.fe", "catenoid.fe", "wire_cube.fe"}) {
    Trial trial(file);
    trial.out("refine 2; vc on");
    trial.out("g 0");
    double before = HUGE_VAL;
    for (int i = 0; i < 5; ++i) {
      trial.out("hessian_seek");
      EXPECT_LE(trial.number("total_energy"), before * (1 + 1e-12)) << file;
      before = trial.number("total_energy");
    }
  }
}

TEST(HessianSeek, PrintsTheScaleAndKeepsBelowTheLimit) {
  Trial trial("wire_cube.fe");
  trial.session().set_quiet(false);
  trial.out("refine");
  EXPECT_TRUE(contains(trial.out("hessian_seek 0.125"), "  scale: 0.125000\n"));
  EXPECT_TRUE(contains(trial.failure("hessian_seek 0"), "limit must be greater than 0"));
}

}  // namespace
}  // namespace lamella::trial
