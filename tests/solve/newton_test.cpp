#include "solve/newton.h"

#include <random>

#include <gtest/gtest.h>

#include "energy/measure.h"
#include "solve/lbfgs.h"
#include "support/equilibria.h"
#include "surgery/equiangulate.h"
#include "surgery/refine.h"

namespace lamella::solve {
namespace {

using scene::Scene;

Scene refined(Scene scene, int times) {
  for (int i = 0; i < times; ++i) surgery::refine(scene.film);
  return scene;
}

// A scene with every term: bodies kept and pressurised, gravity, tensions of facets and edges, open rims.
Scene everything(unsigned seed) {
  Scene scene = test::random_foam(seed);
  scene.bodies[0].density = 1.5;
  scene.bodies[1].target_volume.reset();
  scene.bodies[1].fixed_pressure = 0.7;
  scene.bodies[2].density = 0.4;
  film::Column& tension = scene.film.columns(film::ElementKind::facet).add(film::real_column("tension", 1.0));
  film::Column& pull = scene.film.columns(film::ElementKind::edge).add(film::real_column("tension", 0.0));
  for (std::uint32_t t = 0; t < scene.film.triangle_rows(); t += 3) tension.set(t, 0, 1.7);
  for (std::uint32_t e = 0; e < scene.film.edge_rows(); e += 5) pull.set(e, 0, 0.6);
  return scene;
}

// Minus the gradient of the Lagrangian with given pressures.
std::vector<Vec3> force(Problem& problem, const std::vector<Vec3>& x, const std::vector<double>& pressures) {
  energy::FilmEnergy& energy = problem.energy();
  energy.gradient(x);
  energy.volume_gradient().set_multipliers(pressures);
  std::vector<Vec3> result(x.size());
  for (std::size_t v = 0; v < x.size(); ++v) {
    result[v] = -energy.lines()[v].gradient;
    if (!pressures.empty()) result[v] += energy.volume_gradient().pull(v);
  }
  return result;
}

// Products with random vectors against differences of the gradient.
void expect_hessian(const Scene& scene, MotionKind motion) {
  Problem problem(scene);
  const std::vector<Vec3> x(scene.film.positions().begin(), scene.film.positions().end());
  NewtonSystem system(problem, scene.film, motion);
  bool ok = false;
  system.linearise(x, ok);
  ASSERT_TRUE(ok);
  const Basis& basis = system.basis();
  const std::vector<double> pressures(problem.pressures().begin(), problem.pressures().end());
  std::mt19937 random(9);
  std::uniform_real_distribution<double> u(-1, 1);
  for (int round = 0; round < 3; ++round) {
    std::vector<double> way(basis.size());
    for (double& w : way) w = u(random);
    std::vector<double> image(basis.size());
    system.hessian().multiply(way, image);
    std::vector<Vec3> field(x.size());
    basis.expand(way, field);
    constexpr double h = 2e-4;
    std::vector<double> difference(basis.size());
    for (const double step : {1.0, -1.0, 2.0, -2.0}) {
      std::vector<Vec3> moved = x;
      for (std::size_t v = 0; v < x.size(); ++v) moved[v] += step * h * field[v];
      std::vector<double> part(basis.size());
      basis.reduce(force(problem, moved, pressures), part);
      const double weight = (std::abs(step) == 1 ? -8.0 : 1.0) * (step > 0 ? 1 : -1) / (12 * h);
      for (std::size_t i = 0; i < part.size(); ++i) difference[i] += weight * part[i];
    }
    double size = 0;
    for (const double d : difference) size = std::max(size, std::abs(d));
    for (std::size_t i = 0; i < image.size(); ++i) EXPECT_NEAR(image[i], difference[i], 1e-7 * size) << i;
  }
}

TEST(Hessian, AgreesWithDifferencesOfTheGradient) {
  for (unsigned seed = 1; seed < 4; ++seed) {
    expect_hessian(everything(seed), MotionKind::full);
    expect_hessian(everything(seed), MotionKind::normal);
  }
}

TEST(Hessian, KnowsOpenBodies) {
  for (const bool symmetric : {false, true}) {
    Scene scene = refined(test::open_cap(), 1);
    scene.symmetric_content = symmetric;
    expect_hessian(scene, MotionKind::full);
    scene.bodies[0].target_volume.reset();
    scene.bodies[0].fixed_pressure = 1.3;
    expect_hessian(scene, MotionKind::full);
  }
}

TEST(Basis, ExpandsAndReduces) {
  const Scene scene = test::square_film(4);
  const Problem problem(scene);
  const energy::VertexConstraints none;
  Basis normal(scene.film, problem.weights(), MotionKind::normal, none);
  normal.renew(scene.film.positions(), none);
  EXPECT_EQ(normal.size(), 9U);  // one for each inner vertex; the rim is fixed
  std::vector<Vec3> field(scene.film.vertex_rows(), Vec3{1, 2, 3});
  std::vector<double> reduced(9);
  normal.reduce(field, reduced);
  for (const double r : reduced) EXPECT_EQ(std::abs(r), 3);
  normal.expand(reduced, field);
  EXPECT_EQ(field[12], (Vec3{0, 0, 3}));
  EXPECT_EQ(field[0], Vec3{});
  Basis full(scene.film, problem.weights(), MotionKind::full, none);
  EXPECT_EQ(full.size(), 27U);
}

// The rim of a film that nothing fixes: two directions square to it, three at its corners.
TEST(Basis, GivesRimsTwoDirectionsAndCornersThree) {
  Scene scene = test::square_film(3);
  scene.film.columns(film::ElementKind::vertex).remove("fixed");
  const Problem problem(scene);
  const energy::VertexConstraints none;
  Basis basis(scene.film, problem.weights(), MotionKind::normal, none);
  basis.renew(scene.film.positions(), none);
  for (std::uint32_t v = 0; v < scene.film.vertex_rows(); ++v) {
    const Vec3& p = scene.film.positions()[v];
    const bool rim_x = p.x == 0 || p.x == 1;
    const bool rim_y = p.y == 0 || p.y == 1;
    EXPECT_EQ(basis.count(v), rim_x || rim_y ? 2U : 1U) << v;
    for (std::uint32_t i = basis.first(v); i < basis.first(v + 1); ++i) {
      EXPECT_NEAR(length(basis.direction(i)), 1, 1e-15);
      for (std::uint32_t j = basis.first(v); j < i; ++j)
        EXPECT_NEAR(dot(basis.direction(i), basis.direction(j)), 0, 1e-15);
    }
  }
}

// The residual is quadratic in the gradient, so near the minimum each step squares it and more.
void expect_quadratic(Scene scene, double start) {
  scene::Monitor monitor;
  Problem problem(scene);
  const std::span<Vec3> x = scene.film.edit_positions();
  bool ok = false;
  double energy = 0;
  problem.linearise(x, ok);
  ASSERT_EQ(problem.restore_volumes(x, energy), Ending::converged);
  LbfgsOptions options;
  options.tolerance = start;
  lbfgs(problem, scene, x, options, monitor);
  Newton method(problem, scene.film, MotionKind::normal);
  double last = HUGE_VAL;
  std::vector<double> residuals;
  for (int i = 0; i < 6; ++i) {
    const NewtonStep step = method.step(x, SaddlePolicy::shift);
    ASSERT_EQ(step.ending, Ending::step_limit);
    EXPECT_EQ(step.negative_modes, 0);
    EXPECT_LE(step.energy, last * (1 + 1e-13));
    EXPECT_LT(problem.volume_error(), 1e-12);
    residuals.push_back(step.residual);
    if (step.residual < 1e-24) break;
    last = step.energy;
  }
  EXPECT_LT(residuals.back(), 1e-24) << ::testing::PrintToString(residuals);
  EXPECT_LE(residuals.size(), 5U) << ::testing::PrintToString(residuals);
}

TEST(Newton, ConvergesQuadraticallyOnACube) {
  expect_quadratic(refined(test::cube(), 3), 1e-4);
}

TEST(Newton, ConvergesQuadraticallyOnACatenoid) {
  Scene scene = test::catenoid(0.55, true, 32, 16);
  for (Vec3& p : scene.film.edit_positions()) {
    const double by = 1 + 0.1 * (0.55 * 0.55 - p.z * p.z);
    p = {p.x * by, p.y * by, p.z};
  }
  expect_quadratic(scene, 1);
}

TEST(Newton, NeverRaisesTheEnergyFromFarAway) {
  for (const MotionKind motion : {MotionKind::normal, MotionKind::full}) {
    Scene scene = refined(test::cube(), 2);
    test::jitter(scene.film, 5, 0.03);
    Problem problem(scene);
    const std::span<Vec3> x = scene.film.edit_positions();
    bool ok = false;
    double energy = 0;
    problem.linearise(x, ok);
    ASSERT_EQ(problem.restore_volumes(x, energy), Ending::converged);
    Newton method(problem, scene.film, motion);
    for (int i = 0; i < 10; ++i) {
      const NewtonStep step = method.step(x, SaddlePolicy::shift);
      if (step.ending != Ending::step_limit) break;
      EXPECT_LE(step.energy, energy * (1 + 1e-13));
      energy = step.energy;
    }
    EXPECT_LT(energy, 5.2);
  }
}

}  // namespace
}  // namespace lamella::solve
