#include "solve/modes.h"

#include <gtest/gtest.h>

#include "solve/newton.h"
#include "solve/stability.h"
#include "support/equilibria.h"
#include "surgery/refine.h"

namespace lamella::solve {
namespace {

using scene::Scene;

// A unit sphere's mesh from a cube, at its discrete equilibrium.
Scene sphere(int level) {
  Scene scene = test::cube();
  for (int i = 0; i < level; ++i) surgery::refine(scene.film);
  for (Vec3& p : scene.film.edit_positions()) p = unit(p - Vec3{0.5, 0.5, 0.5});
  scene.bodies[0].target_volume = 4 * M_PI / 3;
  return scene;
}

void settle(Scene& scene, Problem& problem, SaddlePolicy policy) {
  scene::Monitor monitor;
  const std::span<Vec3> x = scene.film.edit_positions();
  bool ok = false;
  double energy = 0;
  problem.linearise(x, ok);
  ASSERT_EQ(problem.restore_volumes(x, energy), Ending::converged);
  Newton method(problem, scene.film, MotionKind::normal);
  NewtonOptions options;
  options.saddle = policy;
  options.tolerance = 1e-20;
  const NewtonReport report = newton(method, x, options, monitor);
  ASSERT_EQ(report.ending, Ending::converged);
  ASSERT_LE(report.steps, 8);
}

Stability stability_of(Scene& scene, Problem& problem) {
  NewtonSystem system(problem, scene.film, MotionKind::normal);
  bool ok = false;
  system.linearise(scene.film.positions(), ok);
  return stability(system);
}

// (l - 1)(l + 2)/R^2 with 2l + 1 modes each; l = 0 changes the volume, l = 1 moves the sphere.
TEST(Modes, OfASphere) {
  Scene scene = sphere(4);
  Problem problem(scene);
  settle(scene, problem, SaddlePolicy::shift);
  NewtonSystem system(problem, scene.film, MotionKind::normal);
  bool ok = false;
  system.linearise(scene.film.positions(), ok);
  scene::Monitor monitor;
  const std::vector<Mode> modes = lowest_modes(system, 15, monitor);
  ASSERT_EQ(modes.size(), 15U);
  for (std::size_t i = 0; i < 15; ++i) {
    const double exact = i < 3 ? 0 : i < 8 ? 4 : 10;
    EXPECT_NEAR(modes[i].value, exact, 0.02 + 0.02 * exact) << i;
    EXPECT_NEAR(modes[i].rigid_part, i < 3 ? 1 : 0, 1e-3) << i;
    // An eigenvector: H x - value M x is a combination of volume gradients, so nothing is left of it within
    // the constraints; here one body, whose gradient is the mass to rounding of the mesh's second order.
    std::vector<double> image(system.hessian().unknowns());
    system.hessian().set_shift(0);
    system.hessian().multiply(modes[i].reduced, image);
    double product = 0;
    for (std::size_t k = 0; k < image.size(); ++k) product += image[k] * modes[i].reduced[k];
    EXPECT_NEAR(product, modes[i].value, 1e-7) << i;
  }
}

TEST(Modes, OfADrum) {
  // A flat unit square: pi^2 (i^2 + j^2).
  Scene scene = test::square_film(16);
  Problem problem(scene);
  NewtonSystem system(problem, scene.film, MotionKind::normal);
  bool ok = false;
  system.linearise(scene.film.positions(), ok);
  scene::Monitor monitor;
  const std::vector<Mode> modes = lowest_modes(system, 4, monitor);
  const double exact[] = {2, 5, 5, 8};
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(modes[i].value / (M_PI * M_PI * exact[i]), 1, 0.03);
  // As many as there are, no more.
  Scene small = test::square_film(4);
  Problem few(small);
  NewtonSystem little(few, small.film, MotionKind::normal);
  little.linearise(small.film.positions(), ok);
  EXPECT_EQ(lowest_modes(little, 50, monitor).size(), 9U);
}

TEST(Stability, SphereIsAMinimumAtEveryResolution) {
  for (int level = 0; level < 5; ++level) {
    Scene scene = sphere(level);
    Problem problem(scene);
    settle(scene, problem, SaddlePolicy::shift);
    const Stability found = stability_of(scene, problem);
    EXPECT_TRUE(found.stable()) << level;
    EXPECT_EQ(found.neutral_modes, 0) << level;
  }
}

TEST(Stability, TellsTheTwoCatenoidsApart) {
  for (const double half : {0.4, 0.55, 0.64}) {
    for (const bool stable : {true, false}) {
      Scene scene = test::catenoid(half, stable, 48, 24);
      Problem problem(scene);
      settle(scene, problem, SaddlePolicy::keep);
      const Stability found = stability_of(scene, problem);
      EXPECT_TRUE(found.known);
      EXPECT_EQ(found.negative_modes, stable ? 0 : 1) << half;
    }
  }
}

// Without volume constraint the sphere under its own pressure is a saddle: it wants to grow or shrink.
TEST(Stability, ASphereUnderFixedPressureIsASaddle) {
  Scene scene = sphere(3);
  Problem kept(scene);
  settle(scene, kept, SaddlePolicy::shift);
  bool ok = false;
  kept.linearise(scene.film.positions(), ok);
  scene.bodies[0].target_volume.reset();
  scene.bodies[0].fixed_pressure = kept.pressures()[0];
  Problem problem(scene);
  EXPECT_EQ(stability_of(scene, problem).negative_modes, 1);
}

}  // namespace
}  // namespace lamella::solve
