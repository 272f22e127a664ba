// What a change of the film's topology leaves of volumes, mass and momentum.
#include <gtest/gtest.h>

#include "evolution/hyperbolic.h"
#include "film/check.h"
#include "film/intersections.h"
#include "support/random_motion.h"

namespace lamella::evolution {
namespace {

using scene::Scene;

// Two bubbles that fly toward each other, not quite head on.
Scene two_bubbles() {
  test::Chance chance(1);
  test::Builder b;
  test::Cells cells(3, 0, chance);
  cells.at(0, 1, 1) = 1;
  cells.at(2, 1, 1) = 2;
  cells.build(b);
  b.film.sort_all_sides();
  Scene scene;
  scene.film = std::move(b.film);
  scene.bodies = {test::body_with_volume(1), test::body_with_volume(1)};
  scene.body_columns.resize(2);
  for (int i = 0; i < 3; ++i) surgery::refine(scene.film);
  std::vector<Vec3> speeds = velocities(scene.film);
  for (std::size_t v = 0; v < speeds.size(); ++v) {
    const bool left = scene.film.positions()[v].x < 1.5;
    speeds[v] = left ? Vec3{0.7, 0.1, 0} : Vec3{-0.5, 0, 0.05};
  }
  store_velocities(scene.film, speeds);
  return scene;
}

TEST(TopologyInMotion, KeepsMomentaMassAndVolumesThroughAMerge) {
  Scene scene = two_bubbles();
  scene::Monitor monitor;
  StepSize size;
  size.topology = true;
  evolve(scene, 1, size, monitor);
  const Balance before = balance(scene);
  ASSERT_GT(length(before.momentum), 0.1);
  int merges = 0;
  double worst_volume = 0;
  for (int spell = 0; spell < 60 && merges == 0; ++spell) {
    const EvolveReport report =
        evolve(scene, 10, size, monitor, {}, [&](Scene&, std::span<const surgery::Event> events) {
          for (const surgery::Event& event : events)
            merges += event.kind == surgery::EventKind::merge ? 1 : 0;
        });
    ASSERT_EQ(report.ending, solve::Ending::step_limit);
    worst_volume = std::max(worst_volume, report.volume_error);
    const Balance after = balance(scene);
    EXPECT_LT(length(after.momentum - before.momentum), 1e-10 * before.mass);
    EXPECT_LT(length(after.angular_momentum - before.angular_momentum), 1e-9 * before.mass);
    EXPECT_NEAR(after.mass, before.mass, 1e-12 * before.mass);
  }
  EXPECT_EQ(merges, 1);
  EXPECT_LT(worst_volume, 1e-9);
  EXPECT_TRUE(film::check(scene.film).empty());
  EXPECT_TRUE(film::self_intersections(scene.film).empty());
}

}  // namespace
}  // namespace lamella::evolution
