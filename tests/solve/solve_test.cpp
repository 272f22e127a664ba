#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "energy/measure.h"
#include "solve/descent.h"
#include "solve/freedom.h"
#include "solve/gram_solver.h"
#include "solve/laplacian.h"
#include "solve/lbfgs.h"
#include "solve/problem.h"
#include "support/differences.h"
#include "support/shapes.h"
#include "surgery/refine.h"

namespace lamella::solve {
namespace {

using scene::Scene;

Scene refined_cube(int times) {
  Scene scene = test::cube();
  for (int i = 0; i < times; ++i) surgery::refine(scene.film);
  return scene;
}

TEST(GramSolver, DenseAndSparseSolveTheSameSystem) {
  for (const int rows : {1, 3, 40, 41, 90}) {
    std::mt19937 random(static_cast<unsigned>(rows));
    std::uniform_real_distribution<double> u(-1, 1);
    std::vector<energy::GramEntry> pattern;
    std::vector<double> values;
    std::vector<std::vector<double>> full(static_cast<std::size_t>(rows),
                                          std::vector<double>(static_cast<std::size_t>(rows)));
    for (int i = 0; i < rows; ++i) {
      for (int j = std::max(0, i - 3); j <= i; ++j) {
        pattern.push_back({i, j});
        values.push_back(i == j ? 8.0 : u(random));
        full[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] = values.back();
        full[static_cast<std::size_t>(j)][static_cast<std::size_t>(i)] = values.back();
      }
    }
    GramSolver solver(rows, pattern);
    ASSERT_TRUE(solver.factorise(values));
    std::vector<double> right(static_cast<std::size_t>(rows));
    for (double& r : right) r = u(random);
    std::vector<double> x(right.size());
    solver.solve(right, x);
    for (std::size_t i = 0; i < right.size(); ++i) {
      double sum = 0;
      for (std::size_t j = 0; j < right.size(); ++j) sum += full[i][j] * x[j];
      EXPECT_NEAR(sum, right[i], 1e-12);
    }
  }
}

TEST(GramSolver, RefusesADependentSystem) {
  GramSolver solver(2, {{0, 0}, {1, 0}, {1, 1}});
  EXPECT_FALSE(solver.factorise(std::vector<double>{1, 1, 1}));
  EXPECT_TRUE(solver.factorise(std::vector<double>{1, 0, 0}));  // the second body cannot be moved at all
}

// L x is the gradient of the film's area (times tension), so the Laplacian is tested against the energy
// itself.
TEST(Laplacian, SolvesForWhatTheGradientIs) {
  Scene scene = test::square_film(8);
  test::jitter(scene.film, 3, 0.01);
  // Sheared, so that no angle is obtuse (obtuse pairs are tamed), and flat, so that the Hessian is L.
  for (Vec3& p : scene.film.edit_positions()) p = {p.x - 0.5 * p.y, p.y, 0};
  std::vector<double> weights(scene.film.vertex_rows(), 1.0);
  const auto fixed = scene.film.columns(film::ElementKind::vertex).flags("fixed");
  for (std::size_t v = 0; v < fixed.size(); ++v) weights[v] = fixed[v] != 0 ? 0 : 1;
  Laplacian laplacian(scene, weights);
  const std::vector<Vec3> x(scene.film.positions().begin(), scene.film.positions().end());
  ASSERT_TRUE(laplacian.factorise(x));
  // For harmonic extension: minus the gradient at a state whose free vertices are lifted must be solved by
  // the lift.
  energy::FilmEnergy energy(scene);
  std::vector<Vec3> lifted = x;
  for (std::size_t v = 0; v < x.size(); ++v) {
    if (weights[v] != 0) lifted[v].z += 1e-6 * std::sin(3.0 * static_cast<double>(v));
  }
  energy.gradient(x);
  std::vector<Vec3> change;
  for (const energy::VertexLine& line : energy.lines()) change.push_back(-1 * line.gradient);
  energy.gradient(lifted);
  for (std::size_t v = 0; v < x.size(); ++v) change[v] += energy.lines()[v].gradient;
  for (std::size_t v = 0; v < x.size(); ++v) {
    if (weights[v] == 0) change[v] = {};
  }
  laplacian.solve(change);
  for (std::size_t v = 0; v < x.size(); ++v) EXPECT_NEAR(change[v].z, lifted[v].z - x[v].z, 2e-8);
}

TEST(Problem, PressuresLeaveTheSmallestProjectedGradient) {
  Scene scene = test::random_foam(5);
  Problem problem(scene);
  bool ok = false;
  problem.linearise(scene.film.positions(), ok);
  ASSERT_TRUE(ok);
  std::vector<Vec3> direction(problem.vertex_count());
  problem.descent_direction(direction);
  std::vector<double> change(problem.constraint_count());
  problem.energy().volume_gradient().dot(problem.weights(), direction, change);
  for (const double c : change) EXPECT_NEAR(c, 0, 1e-12);
}

TEST(Problem, RestoresVolumesToRounding) {
  for (unsigned seed = 0; seed < 5; ++seed) {
    Scene scene = test::random_foam(seed);
    const energy::Measures before = energy::measure(scene);
    for (std::size_t b = 0; b < scene.bodies.size(); ++b)
      scene.bodies[b].target_volume = before.volumes[b + 1] * 1.05;
    Problem problem(scene);
    bool ok = false;
    problem.linearise(scene.film.positions(), ok);
    double energy = 0;
    ASSERT_EQ(problem.restore_volumes(scene.film.edit_positions(), energy), Ending::converged);
    EXPECT_LT(problem.volume_error(), 1e-12);
    EXPECT_NEAR(energy, energy::measure(scene).energy, 1e-12 * energy);
  }
}

TEST(Problem, InflatesAndShrinksFar) {
  for (const double target : {100.0, 1e-4}) {
    Scene scene = refined_cube(2);
    scene.bodies[0].target_volume = target;
    Problem problem(scene);
    bool ok = false;
    problem.linearise(scene.film.positions(), ok);
    double energy = 0;
    ASSERT_EQ(problem.restore_volumes(scene.film.edit_positions(), energy), Ending::converged);
    EXPECT_NEAR(energy::measure(scene).volumes[1] / target, 1, 1e-12);
  }
}

TEST(Problem, SaysWhenAVolumeIsOutOfReach) {
  Scene scene = refined_cube(0);
  film::Column& fixed = scene.film.columns(film::ElementKind::vertex).add(film::flag_column("fixed"));
  for (std::uint32_t v = 0; v < scene.film.vertex_rows(); ++v) fixed.set(v, 0, 1);
  scene.bodies[0].target_volume = 2;
  Problem problem(scene);
  bool ok = false;
  problem.linearise(scene.film.positions(), ok);
  double energy = 0;
  EXPECT_EQ(problem.restore_volumes(scene.film.edit_positions(), energy), Ending::volume_lost);
}

TEST(Descent, LowersEnergyStepByStepAndKeepsVolume) {
  Scene scene = refined_cube(2);
  Problem problem(scene);
  Descent descent(problem);
  const std::span<Vec3> x = scene.film.edit_positions();
  double scale = 0;
  double last = energy::measure(scene).energy;
  for (int i = 0; i < 30; ++i) {
    const DescentStep step = descent.step(x, scale, false, HUGE_VAL);
    ASSERT_EQ(step.ending, Ending::step_limit);
    EXPECT_LT(step.energy, last + 1e-3);  // volumes are nearly right, hence nearly lower
    EXPECT_LT(problem.volume_error(), 1e-4);
    last = step.energy;
  }
  EXPECT_LT(last, 4.87);
}

TEST(Descent, FixedVerticesStay) {
  Scene scene = test::square_film(6);
  test::jitter(scene.film, 2, 0.02);
  const std::vector<Vec3> before(scene.film.positions().begin(), scene.film.positions().end());
  Problem problem(scene);
  Descent descent(problem);
  double scale = 0;
  for (int i = 0; i < 5; ++i) descent.step(scene.film.edit_positions(), scale, false, HUGE_VAL);
  const auto fixed = scene.film.columns(film::ElementKind::vertex).flags("fixed");
  for (std::size_t v = 0; v < before.size(); ++v)
    EXPECT_EQ(fixed[v] != 0, scene.film.positions()[v] == before[v]);
}

TEST(Descent, AnExactMinimumIsLeftAlone) {
  Scene scene = test::square_film(6);
  Problem problem(scene);
  Descent descent(problem);
  const std::vector<Vec3> before(scene.film.positions().begin(), scene.film.positions().end());
  double scale = 0.1;
  const DescentStep step = descent.step(scene.film.edit_positions(), scale, false, HUGE_VAL);
  EXPECT_NEAR(step.energy, 1, 1e-14);
  for (std::size_t v = 0; v < before.size(); ++v)
    EXPECT_LT(length(scene.film.positions()[v] - before[v]), 1e-14);
}

// A scale far too large with the search switched off blows up; positions must come back.
TEST(Descent, UndoesAStepThatIsNotFinite) {
  Scene scene = refined_cube(1);
  scene.bodies[0].target_volume.reset();
  const std::vector<Vec3> before(scene.film.positions().begin(), scene.film.positions().end());
  Problem problem(scene);
  Descent descent(problem);
  double scale = 1e300;
  const DescentStep step = descent.step(scene.film.edit_positions(), scale, true, HUGE_VAL);
  EXPECT_EQ(step.ending, Ending::not_finite);
  for (std::size_t v = 0; v < before.size(); ++v) EXPECT_EQ(scene.film.positions()[v], before[v]);
}

TEST(Freedom, LeavesNormalsInsideSquaresOnLinesAllAtCorners) {
  Scene scene = test::square_film(4);
  Freedom freedom(scene.film, MotionKind::normal);
  freedom.renew(scene.film.positions());
  std::vector<Vec3> field(scene.film.vertex_rows(), Vec3{1, 2, 3});
  freedom.restrict(field);
  EXPECT_EQ(field[2 * 5 + 2], (Vec3{0, 0, 3}));        // inside
  EXPECT_LT(length(field[2] - Vec3{1, 0, 3}), 1e-15);  // on the rim along y
  Freedom full(scene.film, MotionKind::full);
  full.renew(scene.film.positions());
  std::vector<Vec3> same(scene.film.vertex_rows(), Vec3{1, 2, 3});
  full.restrict(same);
  EXPECT_EQ(same[12], (Vec3{1, 2, 3}));
}

// The sphere of volume 1 from a cube: the discrete minimum lies above the exact area by the mesh's second
// order.
TEST(Lbfgs, CubeBecomesASphere) {
  scene::Monitor monitor;
  double last_error = 0;
  for (int level = 2; level <= 4; ++level) {
    Scene scene = refined_cube(level);
    Problem problem(scene);
    LbfgsOptions options;
    options.motion = MotionKind::full;
    options.tolerance = 1e-9;
    const LbfgsReport report = lbfgs(problem, scene, scene.film.edit_positions(), options, monitor);
    EXPECT_EQ(report.ending, Ending::converged);
    const double error = report.energy / 4.835975862049 - 1;
    EXPECT_GT(error, 0);
    if (level > 2) {
      EXPECT_NEAR(last_error / error, 4, 0.4);
    }
    EXPECT_LT(problem.volume_error(), 1e-12);
    last_error = error;
  }
}

TEST(Lbfgs, IterationsDoNotGrowWithTheMesh) {
  scene::Monitor monitor;
  std::vector<long> iterations;
  for (int level = 3; level <= 5; ++level) {
    Scene scene = refined_cube(level);
    Problem problem(scene);
    LbfgsOptions options;
    options.motion = MotionKind::full;
    options.tolerance = 1e-6;
    iterations.push_back(lbfgs(problem, scene, scene.film.edit_positions(), options, monitor).iterations);
  }
  EXPECT_LT(static_cast<double>(iterations[2]), 1.3 * static_cast<double>(iterations[0]));
}

TEST(Lbfgs, StopsBetweenStepsWhenAsked) {
  struct Stopper : scene::Monitor {
    long seen = 0;
    bool stop_requested() override { return ++seen == 3; }
  } stopper;
  Scene scene = refined_cube(3);
  Problem problem(scene);
  const LbfgsReport report = lbfgs(problem, scene, scene.film.edit_positions(), {}, stopper);
  EXPECT_EQ(report.ending, Ending::stopped);
  EXPECT_EQ(report.iterations, 3);
  EXPECT_LT(problem.volume_error(), 1e-12);
}

}  // namespace
}  // namespace lamella::solve
