#include "support/trial.h"

namespace lamella::trial {
namespace {

TEST(Hessian, EndsAtTheEquilibriumInAFewSteps) {
  Trial trial("cube.fe");
  trial.session().set_quiet(false);
  trial.out("refine 3; relax tolerance 1e-5");
  EXPECT_TRUE(trial.out("hessian").starts_with("  1. area: "));
  EXPECT_TRUE(contains(trial.out("hessian 3"), "\n  2. area: "));
  EXPECT_LT(std::abs(trial.number("residual")), 1e-15);
  EXPECT_EQ(trial.number("negative_modes"), 0);
  EXPECT_NEAR(trial.number("body[1].volume"), 1, 1e-13);
  EXPECT_GT(trial.number("body[1].pressure"), 3);
}

// What the discrete equilibrium along normals is does not depend on how it was reached.
TEST(Hessian, AgreesWithRelax) {
  Trial trial("catenoid.fe");
  trial.out("refine 2; relax keep_mesh");
  const double energy = trial.number("total_energy");
  trial.out("hessian; hessian");
  EXPECT_NEAR(trial.number("total_energy"), energy, 1e-10 * energy);
}

TEST(Hessian, RestoresVolumesFirst) {
  Trial trial("cube.fe");
  trial.out("refine 2; relax; body[1].target := 1.1; hessian 3");
  EXPECT_NEAR(trial.number("body[1].volume"), 1.1, 1e-12);
}

TEST(Hessian, Refuses) {
  Trial trial("cube.fe");
  EXPECT_TRUE(contains(trial.failure("hessian -1"), "steps must be at least 0, not -1"));
  EXPECT_TRUE(contains(trial.failure("{ fix vertex; body[1].target := 2; hessian }"),
                       "cannot be brought to their targets"));
  EXPECT_TRUE(contains(Trial().failure("hessian"), "there is no film to move"));
}

}  // namespace
}  // namespace lamella::trial
