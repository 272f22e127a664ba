#include "support/trial.h"

namespace lamella::trial {
namespace {

// A film that is stretched becomes heavier with `area`, and does not with `carried`.
TEST(Mass, FollowsTheAreaOrIsCarried) {
  for (const bool of_area : {false, true}) {
    Trial trial("cube.fe");
    trial.out("refine 2; relax; evolve 1");
    const double before = trial.number("sum(vertices, mass)");
    trial.out(of_area ? "mass area" : "mass carried");
    EXPECT_EQ(trial.out("mass"), of_area ? "mass area\n" : "mass carried\n");
    trial.out("vc 1 2; evolve 1");
    const double wanted = of_area ? trial.number("total_area") : before;
    EXPECT_NEAR(trial.number("sum(vertices, mass)"), wanted, 1e-4);
  }
}

}  // namespace
}  // namespace lamella::trial
