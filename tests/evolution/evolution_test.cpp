#include <cmath>

#include <gtest/gtest.h>

#include "energy/measure.h"
#include "energy/mesh_quality.h"
#include "energy/plateau.h"
#include "evolution/hyperbolic.h"
#include "evolution/motion.h"
#include "evolution/relax.h"
#include "film/check.h"
#include "support/shapes.h"
#include "surgery/refine.h"

namespace lamella::evolution {
namespace {

using film::ElementKind;
using scene::Scene;
using solve::Ending;

Scene bubble(int level) {
  Scene scene = test::cube();
  for (int i = 0; i < level; ++i) surgery::refine(scene.film);
  scene::Monitor monitor;
  relax(scene, {}, monitor);
  return scene;
}

Vec3 momentum(const Scene& scene) {
  const auto v = scene.film.columns(ElementKind::vertex).reals("velocity");
  const auto m = scene.film.columns(ElementKind::vertex).reals("mass");
  Vec3 sum;
  for (std::size_t i = 0; i < m.size(); ++i) sum += m[i] * Vec3{v[3 * i], v[3 * i + 1], v[3 * i + 2]};
  return sum;
}

void set_velocities(Scene& scene, auto&& velocity) {
  film::Column& column = scene.film.columns(ElementKind::vertex).add(film::real_column("velocity", 0, 3));
  for (std::uint32_t v = 0; v < scene.film.vertex_rows(); ++v) {
    const Vec3 value = velocity(scene.film.position(film::Vertex(v)));
    for (int axis = 0; axis < 3; ++axis) column.set(v, axis, value[axis]);
  }
}

TEST(Evolve, KeepsVolumeEnergyAndMomentum) {
  Scene scene = bubble(3);
  set_velocities(scene, [](const Vec3& p) {
    return Vec3{0.1 + 0.2 * (p.x - 0.5), 0.05, -0.2 * (p.z - 0.5)};
  });
  scene::Monitor monitor;
  StepSize size;
  size.upkeep = false;
  evolve(scene, 1, size, monitor);
  const EvolveReport first = evolve(scene, 0, size, monitor);
  const Vec3 before = momentum(scene);
  const EvolveReport report = evolve(scene, 400, size, monitor);
  EXPECT_EQ(report.ending, Ending::step_limit);
  EXPECT_EQ(report.undone, 0);
  EXPECT_LT(report.volume_error, 1e-11);
  EXPECT_NEAR(report.energy + report.kinetic, first.energy + first.kinetic, 2e-4 * first.energy);
  EXPECT_LT(length(momentum(scene) - before), 1e-12);
}

// A bubble at rest stays, one that flies goes on in a straight line: volumes are kept by internal forces.
TEST(Evolve, ARestingBubbleRests) {
  Scene scene = bubble(2);
  scene::Monitor monitor;
  RelaxOptions exact;
  exact.tolerance = 1e-15;
  exact.motion = solve::MotionKind::full;
  relax(scene, exact, monitor);
  const std::vector<Vec3> at(scene.film.positions().begin(), scene.film.positions().end());
  const EvolveReport report = evolve(scene, 50, {}, monitor);
  EXPECT_LT(report.kinetic, 1e-12);
  EXPECT_NEAR(scene.time, 50 * report.largest_dt, 1e-7);
  for (std::size_t v = 0; v < at.size(); ++v) EXPECT_LT(length(scene.film.positions()[v] - at[v]), 1e-5);
}

// omega^2 = sigma (l-1)(l+2)/R^2: the quadrupole of a bubble, by its energy's period (a quarter of a period
// from the stretched shape to the round one).
TEST(Evolve, QuadrupoleOscillatesAtItsFrequency) {
  Scene scene = bubble(3);
  const double radius = std::cbrt(3 / (4 * M_PI));
  for (Vec3& p : scene.film.edit_positions()) {
    const Vec3 d = p - Vec3{0.5, 0.5, 0.5};
    const double z = d.z / length(d);
    p += 0.002 * 0.5 * (3 * z * z - 1) * d;
  }
  const auto quadrupole = [](const Scene& s) {
    double sum = 0;
    for (const Vec3& p : s.film.positions()) {
      const Vec3 d = p - Vec3{0.5, 0.5, 0.5};
      sum += 2 * d.z * d.z - d.x * d.x - d.y * d.y;
    }
    return sum;
  };
  scene::Monitor monitor;
  evolve(scene, 1, {}, monitor);
  // The offset of the relaxed mesh itself is the mean over a period; find two crossings through it by
  // secants.
  const double period = 2 * M_PI * radius / 2;  // omega = 2/R for l = 2
  std::vector<std::pair<double, double>> samples;
  const StepSize step{period / 2000, 0.5};
  double mean = 0;
  const int count = 2 * 2000;
  for (int i = 0; i < count / 10; ++i) {
    evolve(scene, 10, step, monitor);
    samples.emplace_back(scene.time, quadrupole(scene));
    mean += samples.back().second;
  }
  mean /= static_cast<double>(samples.size());
  std::vector<double> crossings;
  for (std::size_t i = 1; i < samples.size(); ++i) {
    const double a = samples[i - 1].second - mean;
    const double b = samples[i].second - mean;
    if (a * b <= 0 && a != b)
      crossings.push_back(samples[i - 1].first + (samples[i].first - samples[i - 1].first) * a / (a - b));
  }
  ASSERT_GE(crossings.size(), 3U);
  EXPECT_NEAR((crossings[2] - crossings[0]) / period, 1, 0.03);
}

TEST(Evolve, AStepAboveTheBoundIsDivided) {
  Scene scene = bubble(2);
  scene::Monitor monitor;
  const double bound = stability_bound(scene);
  const EvolveReport report = evolve(scene, 3, {10 * bound, 0.5}, monitor);
  EXPECT_EQ(report.ending, Ending::step_limit);
  EXPECT_EQ(report.steps, 3);
  EXPECT_GE(report.substeps, 36);
  EXPECT_LE(report.largest_dt, bound);
  EXPECT_NEAR(scene.time, 30 * bound, 1e-10);
}

// The bound is rigorous: far above it a plain step grows without limit, so Motion refuses it.
TEST(Motion, RefusesAStepThatRaisesEnergyFromNowhere) {
  Scene scene = test::square_film(10);
  test::jitter(scene.film, 5, 0.01);
  Motion motion(scene);
  const double dt = 30 * motion.bound();
  Ending ending = Ending::step_limit;
  for (int i = 0; i < 20 && ending == Ending::step_limit; ++i) ending = motion.step(dt);
  EXPECT_EQ(ending, Ending::stuck);
  EXPECT_EQ(motion.step(0.5 * motion.bound()), Ending::step_limit);
}

TEST(Evolve, DampingBringsTheFilmToRest) {
  Scene scene = test::square_film(6);
  test::jitter(scene.film, 5, 0.02);
  const auto fixed = scene.film.columns(ElementKind::vertex).flags("fixed");
  for (std::size_t v = 0; v < fixed.size(); ++v) {
    if (fixed[v] != 0) scene.film.edit_positions()[v].z = 0;
  }
  scene.damping = 3;
  scene::Monitor monitor;
  const EvolveReport report = evolve(scene, 2000, {}, monitor);
  EXPECT_LT(report.kinetic, 1e-9);
}

TEST(Evolve, FollowsATargetThatGrows) {
  Scene scene = bubble(2);
  scene.bodies[0].ramp = scene::VolumeRamp{1, 2, 0, 0.5};
  scene.damping = 2;
  scene::Monitor monitor;
  const EvolveReport report = evolve(scene, 30, {0.01, 0.5}, monitor);
  EXPECT_EQ(report.ending, Ending::step_limit);
  EXPECT_NEAR(energy::measure(scene).volumes[1], 1.6, 1e-9);
  evolve(scene, 30, {0.01, 0.5}, monitor);
  EXPECT_NEAR(energy::measure(scene).volumes[1], 2, 1e-9);
  EXPECT_FALSE(scene.bodies[0].ramp.has_value());
}

TEST(Evolve, FixedVerticesStayAndOpenScenesNeedNoVolumes) {
  Scene scene = test::square_film(5);
  test::jitter(scene.film, 1, 0.02);
  const std::vector<Vec3> before(scene.film.positions().begin(), scene.film.positions().end());
  scene::Monitor monitor;
  evolve(scene, 20, {}, monitor);
  const auto fixed = scene.film.columns(ElementKind::vertex).flags("fixed");
  for (std::size_t v = 0; v < before.size(); ++v)
    EXPECT_EQ(fixed[v] != 0, scene.film.positions()[v] == before[v]);
}

TEST(Relax, ConvergesWithAFitMeshAndExactVolume) {
  for (int level = 2; level <= 4; ++level) {
    Scene scene = test::cube();
    for (int i = 0; i < level; ++i) surgery::refine(scene.film);
    scene::Monitor monitor;
    const RelaxReport report = relax(scene, {}, monitor);
    EXPECT_EQ(report.ending, Ending::converged);
    EXPECT_GT(energy::smallest_angle(scene.film) * 180 / M_PI, 20);
    EXPECT_NEAR(energy::measure(scene).volumes[1], 1, 1e-12);
    EXPECT_LT(report.energy / 4.835975862049 - 1, 0.35 / std::pow(4, level));
    EXPECT_TRUE(film::check(scene.film).empty());
    EXPECT_NEAR(scene.bodies[0].pressure, 2 / std::cbrt(3 / (4 * M_PI)), 0.05);
  }
}

TEST(Relax, RunsUnlabelledFoamsWithoutHarm) {
  for (unsigned seed = 0; seed < 6; ++seed) {
    Scene scene = test::random_foam(seed, 3, 2, 0.1);
    const energy::Measures before = energy::measure(scene);
    for (std::size_t b = 0; b < scene.bodies.size(); ++b)
      scene.bodies[b].target_volume = before.volumes[b + 1];
    scene::Monitor monitor;
    RelaxOptions few;
    few.most_iterations = 60;
    const RelaxReport report = relax(scene, few, monitor);
    EXPECT_LT(report.energy, before.energy);
    EXPECT_TRUE(film::check(scene.film).empty() ||
                film::check(scene.film)[0].find("geometric") != std::string::npos);
    for (std::size_t b = 1; b < before.volumes.size(); ++b) {
      EXPECT_NEAR(energy::measure(scene).volumes[b], before.volumes[b], 1e-10);
    }
  }
}

}  // namespace
}  // namespace lamella::evolution
