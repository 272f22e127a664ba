// Orders, frequencies, conservation and volumes of the integrators.
#include <cmath>

#include <gtest/gtest.h>
#include <omp.h>

#include "evolution/hyperbolic.h"
#include "evolution/masses.h"
#include "evolution/motion.h"
#include "evolution/relax.h"
#include "film/order.h"
#include "support/shapes.h"
#include "surgery/refine.h"

namespace lamella::evolution {
namespace {

using scene::Scene;
using solve::Ending;

const Vec3 centre{0.5, 0.5, 0.5};

Scene bubble_at_rest(int level) {
  Scene scene = test::cube();
  for (int i = 0; i < level; ++i) surgery::refine(scene.film);
  scene::Monitor monitor;
  relax(scene, {}, monitor);
  return scene;
}

double legendre(int l, double z) {
  if (l == 2) return 0.5 * (3 * z * z - 1);
  if (l == 3) return 0.5 * z * (5 * z * z - 3);
  return 0.125 * (35 * z * z * z * z - 30 * z * z + 3);
}

// A velocity along the normal in one mode.
void swing(Scene& scene, int l, double speed) {
  std::vector<Vec3> velocity;
  for (const Vec3& p : scene.film.positions()) {
    const Vec3 n = unit(p - centre);
    velocity.push_back(speed * legendre(l, n.z) * n);
  }
  store_velocities(scene.film, velocity);
}

Scene swinging(int level) {
  Scene scene = bubble_at_rest(level);
  swing(scene, 2, 0.1);
  return scene;
}

std::vector<Vec3> places_after(Scene scene, double time, int steps, Method method) {
  Motion motion(scene, method, VolumeMode::exact);
  for (int i = 0; i < steps; ++i) EXPECT_EQ(motion.step(time / steps), Ending::step_limit);
  motion.store();
  return {scene.film.positions().begin(), scene.film.positions().end()};
}

double distance(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  double sum = 0;
  for (std::size_t v = 0; v < a.size(); ++v) sum += squared_length(a[v] - b[v]);
  return std::sqrt(sum / static_cast<double>(a.size()));
}

// By how much halving the step divides the error, as a power of two. Euler's velocities belong to half steps:
// its path from a given velocity is of first order, as is that of the implicit one.
TEST(Integrators, HaveTheirOrders) {
  const Scene scene = swinging(2);
  const double time = 0.4;
  const std::vector<Vec3> exact = places_after(scene, time, 1600, Method::verlet);
  const auto order = [&](Method method) {
    const double coarse = distance(places_after(scene, time, 40, method), exact);
    const double fine = distance(places_after(scene, time, 80, method), exact);
    return std::log2(coarse / fine);
  };
  EXPECT_NEAR(order(Method::euler), 1, 0.15);
  EXPECT_NEAR(order(Method::implicit), 1, 0.15);
  EXPECT_NEAR(order(Method::verlet), 2, 0.2);
  EXPECT_NEAR(order(Method::midpoint), 2, 0.2);
}

TEST(Integrators, ImplicitOnesSurviveStepsFarBeyondTheBound) {
  for (const Method method : {Method::implicit, Method::midpoint}) {
    Scene scene = swinging(3);
    Motion motion(scene, method);
    const double start = motion.energy() + motion.kinetic();
    const double dt = 7 * motion.bound();
    for (int i = 0; i < 20; ++i) ASSERT_EQ(motion.step(dt), Ending::step_limit);
    EXPECT_LT(motion.volume_error(), 1e-11);
    const double change = (motion.energy() + motion.kinetic() - start) / start;
    if (method == Method::midpoint) {
      EXPECT_LT(std::abs(change), 2e-5);
    } else {
      EXPECT_LT(change, -1e-4);  // this one takes energy
    }
  }
}

// omega^2 = (l-1)(l+2)/R^2: manual/dynamics.md. From the shape at rest to its next crossings.
TEST(Integrators, ABubbleRingsAtItsFrequencies) {
  const Scene rest = bubble_at_rest(4);
  ASSERT_LE(rest.film.triangle_count(), 10000U);
  const double radius = std::cbrt(3 / (4 * M_PI));
  for (int l = 2; l <= 4; ++l) {
    Scene scene = rest;
    swing(scene, l, 0.002);
    Motion motion(scene);
    const auto amplitude = [&] {
      motion.store();
      double sum = 0;
      for (std::uint32_t v = 0; v < scene.film.vertex_rows(); ++v) {
        const Vec3 from = scene.film.position(film::Vertex(v)) - centre;
        const double mass = scene.film.columns(film::ElementKind::vertex).reals("mass")[v];
        sum += mass * legendre(l, from.z / length(from)) * (length(from) - radius);
      }
      return sum;
    };
    const double expected = 2 * M_PI * radius / std::sqrt((l - 1) * (l + 2));
    const double dt = expected / 800;
    ASSERT_LT(dt, motion.bound());
    const double start = amplitude();
    double before = 0;
    double period = 0;
    for (int i = 1; i < 1000 && period == 0; ++i) {
      ASSERT_EQ(motion.step(dt), Ending::step_limit);
      const double now = amplitude() - start;
      if (before < 0 && now >= 0) period = scene.time - dt * now / (now - before);
      before = now;
    }
    EXPECT_NEAR(expected / period, 1, 0.01) << l;
  }
}

// A large film in motion, its sweeps, kicks and products shared out.
TEST(Threads, LeaveMotionAsItIs) {
  const auto moved = [](int threads) {
    const int before = omp_get_max_threads();
    omp_set_num_threads(threads);
    Scene scene = test::cube();
    while (scene.film.triangle_count() < 60000) surgery::refine(scene.film);
    film::restore_spatial_order(scene.film);
    Motion motion(scene);
    for (int i = 0; i < 4; ++i) EXPECT_EQ(motion.step(0.4 * motion.bound()), Ending::step_limit);
    motion.store();
    omp_set_num_threads(before);
    std::vector<Vec3> result(scene.film.positions().begin(), scene.film.positions().end());
    result.push_back({motion.energy(), motion.kinetic(), motion.bound()});
    return result;
  };
  EXPECT_EQ(moved(1), moved(3));
}

// Twenty periods of the quadrupole, undamped.
TEST(Integrators, EnergyStays) {
  Scene scene = bubble_at_rest(3);
  const double radius = std::cbrt(3 / (4 * M_PI));
  swing(scene, 2, 0.02);
  Motion motion(scene, Method::verlet);
  const double start = motion.energy() + motion.kinetic();
  double worst = 0;
  while (scene.time < 20 * M_PI * radius) {
    ASSERT_EQ(motion.step(0.5 * motion.bound()), Ending::step_limit);
    worst = std::max(worst, std::abs(motion.energy() + motion.kinetic() - start));
  }
  EXPECT_LT(worst / start, 1e-3);
}

// Ten thousand steps of a bubble, damped a little: never off by more than 1e-11, in any way of keeping.
TEST(Volumes, StayOverManySteps) {
  for (const VolumeMode mode : {VolumeMode::automatic, VolumeMode::exact}) {
    Scene scene = swinging(2);
    scene.damping = 0.05;
    Motion motion(scene, Method::euler, mode);
    double worst = 0;
    for (int i = 0; i < 10000; ++i) {
      ASSERT_EQ(motion.step(0.35 * motion.bound()), Ending::step_limit);
      worst = std::max(worst, motion.volume_error());
    }
    EXPECT_LT(worst, 1e-11);
  }
}

TEST(Volumes, OnePassLeavesLittleAndNothingAddsUp) {
  Scene scene = swinging(3);
  Motion motion(scene, Method::euler, VolumeMode::lagged);
  double early = 0;
  double late = 0;
  for (int i = 0; i < 2000; ++i) {
    ASSERT_EQ(motion.step(0.4 * motion.bound()), Ending::step_limit);
    double& worst = i < 200 ? early : late;
    worst = std::max(worst, motion.volume_error());
  }
  EXPECT_LT(early, 1e-5);
  EXPECT_LT(late, 1e-6);
}

TEST(Volumes, ThePaperCorrectionKeepsThemToItsOrder) {
  Scene scene = swinging(3);
  Motion motion(scene, Method::euler, VolumeMode::paper);
  for (int i = 0; i < 100; ++i) ASSERT_EQ(motion.step(0.3 * motion.bound()), Ending::step_limit);
  EXPECT_LT(motion.volume_error(), 1e-5);
  EXPECT_GT(motion.volume_error(), 1e-13);
}

// Beyond two hundred volumes systems are solved by iteration: as exact as asked.
TEST(Volumes, ManyAreSolvedByIterationAsByFactors) {
  const int rows = 400;
  std::vector<energy::GramEntry> pattern;
  std::vector<double> values;
  for (int i = 0; i < rows; ++i) {
    for (const int j : {i - 20, i - 1, i}) {
      if (j < 0) continue;
      pattern.push_back({i, j});
      values.push_back(j == i ? 4.5 + 0.01 * i : -1);
    }
  }
  std::vector<double> right(static_cast<std::size_t>(rows));
  for (std::size_t i = 0; i < right.size(); ++i) right[i] = std::sin(static_cast<double>(i));
  std::vector<double> exact(right.size());
  std::vector<double> found(right.size());
  solve::GramSolver factors(rows, pattern);
  solve::GramSolver fastest(rows, pattern, solve::GramSolver::Kind::fastest);
  ASSERT_TRUE(factors.factorise(values));
  ASSERT_TRUE(fastest.factorise(values));
  factors.solve(right, exact);
  for (const double enough : {0.0, 1e-3, 1e-13}) {
    fastest.solve(right, found, enough);
    double worst = 0;
    for (std::size_t i = 0; i < right.size(); ++i) worst = std::max(worst, std::abs(found[i] - exact[i]));
    EXPECT_LT(worst, enough == 0 ? 1e-8 : 3 * enough);
  }
  values[0] = 0;
  EXPECT_FALSE(fastest.factorise(std::vector<double>(values.size(), NAN)));
}

// A run in two parts, each from what the scene holds, is the run in one.
TEST(Volumes, TheirMemoryTravelsWithTheScene) {
  Scene whole = swinging(2);
  Scene parts = whole;
  scene::Monitor monitor;
  StepSize size;
  size.fixed = 0.004;
  evolve(whole, 60, size, monitor);
  evolve(parts, 25, size, monitor);
  evolve(parts, 35, size, monitor);
  for (std::uint32_t v = 0; v < whole.film.vertex_rows(); ++v)
    ASSERT_EQ(whole.film.position(film::Vertex(v)), parts.film.position(film::Vertex(v)));
}

// Upkeep keeps energy and momenta.
TEST(Upkeep, CostsNoEnergy) {
  Scene scene = bubble_at_rest(3);
  swing(scene, 2, 0.4);
  std::vector<Vec3> velocity = velocities(scene.film);
  for (std::size_t v = 0; v < velocity.size(); ++v)
    velocity[v] += cross(Vec3{0, 0, 0.3}, scene.film.positions()[v] - centre);
  store_velocities(scene.film, velocity);
  scene::Monitor monitor;
  StepSize size;
  size.method = Method::verlet;
  evolve(scene, 1, size, monitor);
  const EvolveReport first = evolve(scene, 0, size, monitor);
  const Balance before = balance(scene);
  const EvolveReport last = evolve(scene, 1500, size, monitor);
  EXPECT_GT(last.upkeeps, 0);
  EXPECT_NEAR(last.energy + last.kinetic, first.energy + first.kinetic, 1e-3 * first.energy);
  const Balance after = balance(scene);
  EXPECT_LT(length(after.momentum - before.momentum), 1e-10);
  EXPECT_LT(length(after.angular_momentum - before.angular_momentum), 1e-4);
}

}  // namespace
}  // namespace lamella::evolution
