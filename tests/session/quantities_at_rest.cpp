// Newton's method and the verdict of relax where quantities bring second derivatives of their own.
#include "support/trial.h"

namespace lamella::trial {
namespace {

std::string cube_with(const Folder& folder, const std::string& top) {
  return folder.write("scene.fe", top + "\n#include \"" + datafile("cube.fe") + "\"\n");
}

TEST(QuantitiesAtRest, NewtonsMethodKnowsTheSecondDerivativesOfCurvatures) {
  for (const char* const method :
       {"sq_mean_curvature global", "star_perp_sq_mean_curvature global", "mean_curvature_integral global"}) {
    SCOPED_TRACE(method);
    const Folder folder;
    Trial trial;
    trial.session().load(
        cube_with(folder, std::string("quantity bend energy modulus 0.05 method ") + method));
    trial.out("refine 2; relax");
    EXPECT_EQ(trial.number("converged"), 1);
    EXPECT_EQ(trial.number("stable"), 1);
    // From a little away each step squares what is left, to rounding.
    trial.out("set vertex z z * 1.01; recalc; hessian 4; hessian");
    EXPECT_LT(std::abs(trial.number("residual")), 1e-18);
  }
}

// The elastic energy of a sphere is the same at every size: with a volume kept it adds nothing to the area's
// forces but numerical ones, which go with refinement.
TEST(QuantitiesAtRest, SpheresStaySpheres) {
  const Folder folder;
  Trial trial;
  trial.session().load(
      cube_with(folder, "quantity bend energy modulus 0.05 method star_perp_sq_mean_curvature global"));
  trial.out("refine 3; relax");
  const double willmore = trial.number("bend.value") / trial.number("bend.modulus");
  EXPECT_NEAR(willmore, 4 * M_PI, 0.05 * 4 * M_PI);
}

TEST(QuantitiesAtRest, FormulasReadTargets) {
  const Folder folder;
  Trial trial;
  trial.session().load(folder.write("scene.fe", R"(
quantity vol fixed = 0.5 method facet_vector_integral
vector_integrand:
q1: 0
q2: 0
q3: z
quantity part info_only method facet_vector_integral
vector_integrand:
q1: 0
q2: 0
q3: z/vol.target
vertices
1 0 0 1 fixed
2 1 0 1 fixed
3 0 1 1 fixed
edges
1 1 2
2 2 3
3 3 1
faces
1 1 2 3 vol part
)"));
  EXPECT_NEAR(trial.number("part.value"), 1, 1e-15);
  trial.out("vol.target := 0.25");
  EXPECT_NEAR(trial.number("part.value"), 2, 1e-15);
  EXPECT_TRUE(contains(trial.out("print vol.target"), "0.25"));
  // Saved, it is a formula still.
  trial.out("save \"" + (folder / "again.fe") + "\"");
  Trial again;
  again.session().load(folder / "again.fe");
  EXPECT_NEAR(again.number("part.value"), 2, 1e-15);
}

}  // namespace
}  // namespace lamella::trial
