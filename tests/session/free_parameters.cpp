// Parameters that are unknowns beside the vertices.
#include "solve/free_parameters.h"

#include "solve/parameter_border.h"
#include "support/trial.h"

namespace lamella::trial {
namespace {

using film::Vec3;

// A plate on a drop, off its place and with every vertex shaken.
class ShakenDrop : public Trial {
 public:
  ShakenDrop() : Trial("drop_under_plate.fe") {
    out("refine; relax 3; set vertex x x + 0.03*sin(7*id) where not fixed; recalc");
  }
};

std::vector<Vec3> positions(const scene::Scene& scene) {
  return {scene.film.positions().begin(), scene.film.positions().end()};
}

TEST(FreeParameters, SlopesAreThoseOfTheFilmThatFollows) {
  ShakenDrop trial;
  const double energy = trial.number("total_energy");
  const double volume = trial.number("body[1].volume");
  solve::Problem problem(trial.session().scene());
  const std::vector<Vec3> x = positions(trial.session().scene());
  bool ok = false;
  problem.linearise(x, ok);
  ASSERT_TRUE(ok);
  ASSERT_EQ(problem.parameters().size(), 2U);
  const char* const names[] = {"height", "shift"};
  for (std::size_t k = 0; k < 2; ++k) {
    const std::string name = names[k];
    const auto both = [&](double by) {
      ShakenDrop moved;
      moved.out(fmt::format("{0} := {0} + {1:.17g}; recalc", name, by));
      return std::array{moved.number("total_energy"), moved.number("body[1].volume")};
    };
    const double step = 1e-4;
    const auto up = both(step);
    const auto down = both(-step);
    EXPECT_NEAR(problem.parameters().slope(k), (up[0] - down[0]) / (2 * step), 1e-6 * std::abs(energy))
        << name;
    EXPECT_NEAR(problem.parameters().held_slope(k, 0), (up[1] - down[1]) / (2 * step), 1e-6 * volume) << name;
  }
}

// The mixed derivatives against differences of the slopes by parameters.
TEST(FreeParameters, MixedDerivativesAreSymmetric) {
  ShakenDrop trial;
  const scene::Scene& scene = trial.session().scene();
  solve::Problem problem(scene);
  std::vector<Vec3> x = positions(scene);
  bool ok = false;
  problem.linearise(x, ok);
  ASSERT_TRUE(ok);
  solve::Basis basis(scene.film, problem.weights(), solve::MotionKind::full, problem.energy().constraints());
  basis.renew(x, problem.energy().constraints());
  const solve::ParameterBorder border = solve::parameter_border(problem, basis, x, ok);
  ASSERT_TRUE(ok);
  const std::vector<double> pressures(problem.pressures().begin(), problem.pressures().end());
  const auto slope = [&](std::size_t k) {
    solve::FreeParameters parameters(scene);
    energy::FilmEnergy energy(scene);
    EXPECT_TRUE(parameters.differentiate(energy, x));
    return parameters.slope(k) - pressures[0] * parameters.held_slope(k, 0);
  };
  const double step = 1e-3;
  for (std::size_t v = 0; v < basis.vertex_count(); v += 5) {
    for (std::size_t i = basis.first(v); i < basis.first(v + 1); ++i) {
      for (std::size_t k = 0; k < 2; ++k) {
        x[v] += step * basis.direction(i);
        const double ahead = slope(k);
        x[v] -= 2 * step * basis.direction(i);
        const double behind = slope(k);
        x[v] += step * basis.direction(i);
        EXPECT_NEAR(border.columns[k][i], (ahead - behind) / (2 * step), 2e-5) << v << ' ' << k;
      }
    }
  }
}

// The plate settles over the middle of the other, at the height where the drop's energy and its own balance.
TEST(FreeParameters, TheFilmAndTheyComeToOneEquilibrium) {
  const std::string end = "; hessian_normal off; {hessian} 6";
  for (const char* const way : {"g 100", "conj_grad on; g 50; conj_grad off"}) {
    SCOPED_TRACE(way);
    Trial trial("drop_under_plate.fe");
    trial.out(std::string("refine; ") + way + end);
    const double energy = trial.number("total_energy");
    EXPECT_NEAR(trial.number("shift"), 0, 1e-8);
    EXPECT_NEAR(trial.number("body[1].volume"), 4, 1e-12);
    EXPECT_NEAR(trial.number("height.p_velocity"), 0, 1e-6);
    // With the plate held a little higher or lower the film has more energy, and as much more.
    const double height = trial.number("height");
    const auto held_at = [&](double at) {
      trial.out(fmt::format("fix height; fix shift; height := {:.17g}{}", at, end));
      return trial.number("total_energy") - energy;
    };
    const double above = held_at(height + 0.002);
    const double below = held_at(height - 0.002);
    EXPECT_GT(above, 1e-6);
    EXPECT_NEAR(above, below, 0.1 * above);
  }
}

// A plate that is driven the more the farther it has slid stands in the middle on a saddle.
TEST(FreeParameters, TheirModesCount) {
  Trial trial("drop_under_plate.fe");
  trial.out("shift := 0; refine; g 50; hessian_normal off; {hessian} 6");
  EXPECT_EQ(trial.number("negative_modes"), 0);
  trial.out("drive := 20; hessian");
  EXPECT_EQ(trial.number("negative_modes"), 1);
  trial.out("fix shift; hessian");
  EXPECT_EQ(trial.number("negative_modes"), 0);
}

TEST(FreeParameters, NewtonsMethodEndsQuadratically) {
  Trial trial("drop_under_plate.fe");
  trial.out("refine; g 50; hessian_normal off; {hessian} 6; height := height + 0.01; shift := 0.01");
  std::vector<double> residuals;
  for (int step = 0; step < 5; ++step) {
    trial.out("hessian");
    residuals.push_back(std::abs(trial.number("residual")));
  }
  EXPECT_GT(residuals[0], 1e-6);
  EXPECT_LT(residuals[2], 1e-4 * residuals[1]);
  EXPECT_LT(residuals[4], 1e-20);
}

TEST(FreeParameters, RelaxFindsThem) {
  Trial trial("drop_under_plate.fe");
  trial.out("refine; relax");
  EXPECT_EQ(trial.number("converged"), 1);
  EXPECT_EQ(trial.number("stable"), 1);
  EXPECT_NEAR(trial.number("shift"), 0, 0.01);  // the mesh that relax makes has no symmetry
  EXPECT_NEAR(trial.number("height.p_velocity"), 0, 1e-3);
}

TEST(FreeParameters, AreSavedAndRead) {
  const Folder folder;
  Trial trial("drop_under_plate.fe");
  trial.out("fix shift; height.pscale := 2; save \"" + (folder / "a.fe") + "\"");
  Trial again;
  again.session().load(folder / "a.fe");
  EXPECT_EQ(again.number("height.fixed"), 0);
  EXPECT_EQ(again.number("height.pscale"), 2);
  EXPECT_EQ(again.number("height.pdelta"), 1e-5);
  EXPECT_EQ(again.number("shift.fixed"), 1);
}

TEST(FreeParameters, SayWhichPartsThereAre) {
  Trial trial("drop_under_plate.fe");
  EXPECT_NE(trial.failure("height.pscal := 2").find("did you mean \"height.pscale\"?"), std::string::npos);
  EXPECT_NE(trial.failure("print height.force").find("did you mean \"height.p_force\"?"), std::string::npos);
  EXPECT_NE(trial.failure("print height.colour").find("there are height.fixed, "), std::string::npos);
}

TEST(FreeParameters, MovingPlatesDoNotDisturbMotion) {
  Trial trial("drop_under_plate.fe");
  trial.out("refine; relax");
  const double height = trial.number("height");
  trial.out("evolve 5");
  EXPECT_EQ(trial.number("height"), height);
}

}  // namespace
}  // namespace lamella::trial
