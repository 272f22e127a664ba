#include "surgery/remesh.h"

#include <gtest/gtest.h>

#include "energy/measure.h"
#include "film/check.h"
#include "film/intersections.h"
#include "support/shapes.h"
#include "surgery/keep_topology.h"
#include "surgery/link.h"
#include "surgery/merge.h"
#include "surgery/proximity.h"
#include "surgery/refine.h"
#include "surgery/regions.h"
#include "surgery/shrink.h"
#include "surgery/sizing.h"
#include "surgery/tangle_watch.h"

namespace lamella::surgery {
namespace {

using film::Edge;
using film::Film;
using film::Region;
using film::Triangle;
using film::Vec3;
using film::Vertex;
using scene::Scene;

void expect_sound(const Film& film) {
  const auto found = check(film);
  ASSERT_TRUE(found.empty()) << found[0];
  const auto labels = check_regions(film);
  ASSERT_TRUE(labels.empty()) << labels[0];
}

// A ball of facets: a cube, refined and blown up.
Scene ball(const Vec3& centre, int times, double radius = 1) {
  Scene scene = test::cube(2, {-1, -1, -1});
  for (int i = 0; i < times; ++i) refine(scene.film);
  for (Vec3& p : scene.film.edit_positions()) p = centre + radius * unit(p);
  return scene;
}

// Two films in one: numbers of regions of the second follow those of the first.
Scene both(const Scene& a, const Scene& b) {
  test::Builder builder;
  std::uint32_t shift = 0;
  std::uint32_t rows = 0;
  for (const Scene* scene : {&a, &b}) {
    for (const Vec3& p : scene->film.positions()) builder.vertex(p);
    const auto moved = [&](Region r) { return r.outside() ? r : Region{r.index + shift}; };
    for (std::uint32_t t = 0; t < scene->film.triangle_rows(); ++t) {
      const auto& c = scene->film.corners(Triangle(t));
      const film::RegionPair pair = scene->film.regions(Triangle(t));
      builder.triangle(Vertex(c[0].index + rows), Vertex(c[1].index + rows), Vertex(c[2].index + rows),
                       {moved(pair.front), moved(pair.behind)});
    }
    shift += static_cast<std::uint32_t>(scene->bodies.size());
    rows += scene->film.vertex_rows();
  }
  Scene scene;
  scene.film = std::move(builder.film);
  scene.bodies = a.bodies;
  scene.bodies.insert(scene.bodies.end(), b.bodies.begin(), b.bodies.end());
  return scene;
}

double volume(const Scene& scene, std::uint32_t region) {
  return energy::measure(scene).volumes[region];
}

// What collapses at all leaves a sound film with no change of its topology, and what is refused leaves it as
// it was, to the bit.
TEST(Shrink, KeepsRandomFoamsSound) {
  for (unsigned seed = 0; seed < 6; ++seed) {
    Scene scene = test::random_foam(seed);
    refine(scene.film);
    scene.film.sort_all_sides();
    int done = 0;
    for (std::uint32_t e = 0; e < scene.film.edge_rows(); e += 3) {
      if (!scene.film.alive(Edge(e))) continue;
      const auto revision = scene.film.connectivity_revision();
      const Shrink shrink = shrink_edge(scene, Edge(e), 10);
      if (shrink.outcome == ShrinkOutcome::done) {
        ++done;
      } else {
        EXPECT_EQ(scene.film.connectivity_revision(), revision);
      }
    }
    EXPECT_GT(done, 10);
    expect_sound(scene.film);
  }
}

// Collapses inside a film keep its volume exactly.
TEST(Shrink, KeepsTheVolume) {
  Scene scene = ball({}, 3);
  const double before = volume(scene, 1);
  int done = 0;
  for (std::uint32_t e = 0; e < scene.film.edge_rows(); e += 7) {
    if (scene.film.alive(Edge(e)) && shrink_edge(scene, Edge(e), 10).outcome == ShrinkOutcome::done) ++done;
  }
  EXPECT_GT(done, 50);
  scene.film.compact();
  EXPECT_NEAR(volume(scene, 1), before, 1e-6 * before);
}

TEST(Remesh, KeepsRandomFoamsSound) {
  for (unsigned seed = 0; seed < 6; ++seed) {
    Scene scene = test::random_foam(seed);
    refine(scene.film);
    scene.film.sort_all_sides();
    for (const double size : {0.25, 0.8}) {
      set_sizes(
          scene.film, [&](Vertex) { return size; }, size, size);
      for (int round = 0; round < 4; ++round) remesh(scene, {});
      expect_sound(scene.film);
      scene.film.compact();
    }
  }
}

TEST(Remesh, LeavesAnEvenFilmAlone) {
  Scene scene = ball({}, 3);
  keep_sizes(scene.film);
  for (int round = 0; round < 4; ++round) remesh(scene, {});
  scene.film.compact();
  const auto connectivity = scene.film.connectivity_revision();
  const auto positions = scene.film.position_revision();
  EXPECT_FALSE(needs_remesh(scene.film, scene.film.positions(), {}));
  EXPECT_EQ(remesh(scene, {}).operations(), 0);
  EXPECT_EQ(scene.film.connectivity_revision(), connectivity);
  EXPECT_EQ(scene.film.position_revision(), positions);
}

// Balls of several sizes, touching: every pair merges, with a wall between.
TEST(Merge, BallsThatTouch) {
  for (const double radius : {0.7, 1.0, 1.3}) {
    for (const double turn : {0.0, 0.7, 1.9}) {
      for (const double gap : {0.02, 0.05}) {
        const Scene a = ball({}, 3);
        Scene b = ball({}, 3, radius);
        test::rotate_all(b.film, {1, 2, 3}, turn);
        test::move_all(b.film, {0.1, 0.2, 1 + radius + gap - 0.02});
        Scene scene = both(a, b);
        ASSERT_TRUE(film::self_intersections(scene.film).empty());
        keep_sizes(scene.film);
        TangleWatch watch;
        watch.look(scene.film);
        Proximity proximity(0.6, 0);
        proximity.update(scene.film, watch.near_pairs());
        const auto contacts = proximity.contacts();
        ASSERT_FALSE(contacts.empty());
        bool merged = false;
        for (std::size_t i = 0; i < contacts.size() && i < 6 && !merged; ++i)
          merged = merge(scene, contacts[i].pair, size_of(scene.film, contacts[i].pair.vertex)).has_value();
        ASSERT_TRUE(merged) << radius << " " << turn << " " << gap;
        expect_sound(scene.film);
        EXPECT_TRUE(film::self_intersections(scene.film).empty());
        scene.film.compact();
        int walls = 0;
        for (std::uint32_t t = 0; t < scene.film.triangle_rows(); ++t) {
          const film::RegionPair pair = scene.film.regions(Triangle(t));
          walls += !pair.front.outside() && !pair.behind.outside() ? 1 : 0;
        }
        EXPECT_GT(walls, 0);
      }
    }
  }
}

TEST(Proximity, EmptyWhereSheetsKeepApart) {
  Scene scene = both(ball({}, 3), ball({0, 0, 3}, 3));
  keep_sizes(scene.film);
  TangleWatch watch;
  watch.look(scene.film);
  Proximity proximity(0.15, 0.5);
  proximity.update(scene.film, watch.near_pairs());
  EXPECT_TRUE(proximity.empty());
}

// A body of two balls becomes two, and the target is shared by their volumes.
TEST(Regions, ABodyThatFallsApartBecomesTwo) {
  Scene scene = both(ball({}, 2, 1), ball({0, 0, 3}, 2, 0.5));
  for (std::uint32_t t = 0; t < scene.film.triangle_rows(); ++t) {
    film::RegionPair pair = scene.film.regions(Triangle(t));
    if (!pair.front.outside()) pair.front = Region{1};
    if (!pair.behind.outside()) pair.behind = Region{1};
    scene.film.set_regions(Triangle(t), pair);
  }
  scene.bodies.resize(1);
  scene.bodies[0].target_volume = 9;
  const auto events = settle_regions(scene, {}, {});
  ASSERT_EQ(events.size(), 1U);
  EXPECT_EQ(events[0].kind, EventKind::split);
  ASSERT_EQ(scene.bodies.size(), 2U);
  EXPECT_NEAR(*scene.bodies[0].target_volume, 8, 1e-9);
  EXPECT_NEAR(*scene.bodies[1].target_volume, 1, 1e-9);
  EXPECT_NEAR(volume(scene, 1) / volume(scene, 2), 8, 1e-9);
  EXPECT_TRUE(settle_regions(scene, {}, {}).empty());
}

TEST(Regions, AFilmThatClosesMakesABody) {
  Scene scene = ball({}, 2);
  for (std::uint32_t t = 0; t < scene.film.triangle_rows(); ++t) scene.film.set_regions(Triangle(t), {});
  scene.bodies.clear();
  EXPECT_TRUE(settle_regions(scene, {}, {}).empty());
  const Triangle touched(0U);
  const auto events = settle_regions(scene, std::span(&touched, 1), {});
  ASSERT_EQ(events.size(), 1U);
  EXPECT_EQ(events[0].kind, EventKind::birth);
  ASSERT_EQ(scene.bodies.size(), 1U);
  EXPECT_NEAR(*scene.bodies[0].target_volume, volume(scene, 1), 1e-12);
  expect_sound(scene.film);
}

}  // namespace
}  // namespace lamella::surgery
