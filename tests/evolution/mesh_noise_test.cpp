// What motion of the mesh is taken out of a film's velocities, and what stays.
#include "evolution/mesh_noise.h"

#include <gtest/gtest.h>

#include "evolution/balance.h"
#include "evolution/masses.h"
#include "support/random_motion.h"
#include "surgery/refine.h"

namespace lamella::evolution {
namespace {

using scene::Scene;

// Two bubbles apart, each vertex shaken; the second flies.
Scene shaken_bubbles(double shake) {
  test::Chance chance(7);
  test::Builder b;
  test::Cells cells(5, 0, chance);
  cells.at(0, 1, 1) = 1;
  cells.at(1, 1, 1) = 2;
  cells.at(4, 1, 1) = 3;
  cells.build(b);
  b.film.sort_all_sides();
  Scene scene;
  scene.film = std::move(b.film);
  scene.bodies = {test::body_with_volume(1), test::body_with_volume(1), test::body_with_volume(1)};
  scene.body_columns.resize(3);
  for (int i = 0; i < 2; ++i) surgery::refine(scene.film);
  std::vector<Vec3> speeds(scene.film.vertex_rows());
  std::vector<double> masses;
  for (std::size_t v = 0; v < speeds.size(); ++v) {
    speeds[v] = chance.vector(shake);
    if (scene.film.positions()[v].x > 2.5) speeds[v] += Vec3{3, 0, 0};
    masses.push_back(chance.real(0.5, 1.5));
  }
  store_motion(scene.film, masses, speeds);
  return scene;
}

// Of the bubble that flies.
Vec3 momentum_of_flier(const Scene& scene) {
  const std::vector<Vec3> speeds = velocities(scene.film);
  const auto masses = scene.film.columns(film::ElementKind::vertex).reals("mass");
  Vec3 sum;
  for (std::size_t v = 0; v < speeds.size(); ++v) {
    if (scene.film.positions()[v].x > 2.5) sum += masses[v] * speeds[v];
  }
  return sum;
}

TEST(MeshNoise, GoesWithBothMomentaKept) {
  Scene scene = shaken_bubbles(1);
  const Balance before = balance(scene);
  damp_mesh_noise(scene, 0.5, false);
  const Balance after = balance(scene);
  EXPECT_LT(length(after.momentum - before.momentum), 1e-12 * before.mass);
  EXPECT_LT(length(after.angular_momentum - before.angular_momentum), 1e-11 * before.mass);
  EXPECT_LT(after.kinetic, 0.95 * before.kinetic);
}

TEST(MeshNoise, GivesItsEnergyBackToTheSameBubble) {
  Scene scene = shaken_bubbles(1);
  const Balance before = balance(scene);
  const Vec3 flier = momentum_of_flier(scene);
  damp_mesh_noise(scene, 0.1, true);
  const Balance after = balance(scene);
  EXPECT_NEAR(after.kinetic, before.kinetic, 1e-12 * before.kinetic);
  EXPECT_LT(length(momentum_of_flier(scene) - flier), 1e-11 * length(flier));
  EXPECT_LT(length(after.angular_momentum - before.angular_momentum), 1e-11 * before.mass);
}

TEST(MeshNoise, LeavesAFilmThatFliesAndTurnsAsItIs) {
  Scene scene = shaken_bubbles(0);
  std::vector<Vec3> speeds = velocities(scene.film);
  for (std::size_t v = 0; v < speeds.size(); ++v)
    speeds[v] = Vec3{1, 2, 3} + cross(Vec3{0.3, -0.2, 0.5}, scene.film.positions()[v]);
  store_velocities(scene.film, speeds);
  damp_mesh_noise(scene, 0.5, true);
  const std::vector<Vec3> after = velocities(scene.film);
  for (std::size_t v = 0; v < speeds.size(); ++v) ASSERT_LT(length(after[v] - speeds[v]), 1e-12);
}

TEST(MeshNoise, LeavesVerticesAloneThatAreFixed) {
  Scene scene = shaken_bubbles(1);
  film::Column& fixed = scene.film.columns(film::ElementKind::vertex)
                            .add(film::flag_column("fixed", film::Inheritance::New::parent));
  std::vector<Vec3> speeds = velocities(scene.film);
  for (std::uint32_t v = 0; v < speeds.size(); v += 5) {
    fixed.set(v, 0, 1);
    speeds[v] = {};
  }
  store_velocities(scene.film, speeds);
  const double before = balance(scene).kinetic;
  damp_mesh_noise(scene, 0.02, true);
  for (std::uint32_t v = 0; v < speeds.size(); v += 5) EXPECT_EQ(velocities(scene.film)[v], Vec3{});
  EXPECT_NEAR(balance(scene).kinetic, before, 1e-12 * before);
}

}  // namespace
}  // namespace lamella::evolution
