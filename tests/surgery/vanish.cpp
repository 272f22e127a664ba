#include "surgery/vanish.h"

#include <gtest/gtest.h>

#include "film/check.h"
#include "film/intersections.h"
#include "support/shapes.h"
#include "surgery/contract.h"
#include "surgery/link.h"
#include "surgery/regions.h"
#include "surgery/sizing.h"

namespace lamella::surgery {
namespace {

using film::Film;
using film::Region;
using film::Vec3;
using film::Vertex;
using scene::Scene;

void give_size(Scene& scene, double size) {
  set_sizes(
      scene.film, [&](Vertex) { return size; }, size, size);
}

std::vector<Event> vanish_and_settle(Scene& scene) {
  std::vector<Event> events = vanish_small_parts(scene).events;
  settle_regions(scene, events, {});
  scene.film.compact();
  return events;
}

void expect_sound(const Film& film) {
  EXPECT_TRUE(film::check(film).empty());
  EXPECT_TRUE(film::check_regions(film).empty());
  EXPECT_TRUE(film::self_intersections(film).empty());
}

// A flat film with a lens in the middle: two caps of three facets each on a triangle of borders.
Scene film_with_lens(double radius) {
  test::Builder b;
  std::vector<Vertex> inner;
  std::vector<Vertex> outer;
  for (int i = 0; i < 3; ++i) {
    const double angle = 2 * M_PI * i / 3;
    inner.push_back(b.vertex(radius * Vec3{std::cos(angle), std::sin(angle), 0}));
    outer.push_back(b.vertex({std::cos(angle), std::sin(angle), 0}));
  }
  const Vertex top = b.vertex({0, 0, 0.5 * radius});
  const Vertex bottom = b.vertex({0, 0, -0.5 * radius});
  const auto at = [](const std::vector<Vertex>& v, int i) { return v[std::size_t(i % 3)]; };
  for (int i = 0; i < 3; ++i) {
    b.triangle(at(inner, i), at(inner, i + 1), top, {Region{0}, Region{1}});
    b.triangle(at(inner, i + 1), at(inner, i), bottom, {Region{0}, Region{1}});
    b.triangle(at(outer, i), at(outer, i + 1), at(inner, i));
    b.triangle(at(outer, i + 1), at(inner, i + 1), at(inner, i));
  }
  film::Column& fixed = b.film.columns(film::ElementKind::vertex)
                            .add(film::flag_column("fixed", film::Inheritance::New::parent));
  for (const Vertex v : outer) fixed.set(v.index, 0, 1);
  b.film.sort_all_sides();
  Scene scene;
  scene.film = std::move(b.film);
  scene.bodies.push_back(test::body_with_volume(1e-3));
  return scene;
}

TEST(Vanish, ATinyBubbleIsGone) {
  Scene scene = test::cube(0.1);
  give_size(scene, 1);
  EXPECT_TRUE(has_small_parts(scene));
  const std::vector<Event> events = vanish_and_settle(scene);
  ASSERT_EQ(events.size(), 1U);
  EXPECT_EQ(events[0].kind, EventKind::vanish);
  EXPECT_EQ(scene.film.triangle_count(), 0U);
  EXPECT_EQ(scene.film.vertex_count(), 0U);
  EXPECT_TRUE(scene.bodies[0].absent);
  EXPECT_FALSE(scene.has_fixed_volume());
}

TEST(Vanish, WhatIsAsLargeAsItsMeshStays) {
  Scene scene = test::cube();
  keep_sizes(scene.film);
  EXPECT_FALSE(has_small_parts(scene));
  EXPECT_TRUE(vanish_small_parts(scene).events.empty());
  EXPECT_EQ(scene.film.triangle_count(), 24U);
}

TEST(Vanish, ALensInAFilmClosesToAPoint) {
  Scene scene = film_with_lens(0.1);
  give_size(scene, 0.6);
  const std::vector<Event> events = vanish_and_settle(scene);
  ASSERT_EQ(events.size(), 1U);
  EXPECT_EQ(events[0].kind, EventKind::vanish);
  EXPECT_EQ(events[0].regions, (std::vector<Region>{Region{0}, Region{1}}));
  EXPECT_TRUE(scene.bodies[0].absent);
  EXPECT_EQ(scene.film.triangle_count(), 3U);
  expect_sound(scene.film);
  for (std::uint32_t v = 0; v < scene.film.vertex_rows(); ++v) {
    const Vertex at(v);
    EXPECT_TRUE(!is_free(scene, at) || kind_of(link_of(scene.film, at)) == LinkKind::disc);
  }
}

TEST(Vanish, WhatIsHeldStays) {
  Scene scene = test::cube(0.1);
  give_size(scene, 1);
  scene.film.columns(film::ElementKind::vertex)
      .add(film::flag_column("fixed", film::Inheritance::New::parent))
      .set(0, 0, 1);
  EXPECT_FALSE(has_small_parts(scene));
}

TEST(Vanish, AScrapOfFilmIsGone) {
  Scene scene = test::square_film(1, 0.2);
  scene.film.columns(film::ElementKind::vertex).edit_each([](film::Column& column) {
    if (column.name == "fixed")
      for (std::uint32_t v = 0; v < 4; ++v) column.set(v, 0, 0);
  });
  give_size(scene, 1);
  EXPECT_EQ(vanish_and_settle(scene).size(), 1U);
  EXPECT_EQ(scene.film.triangle_count(), 0U);
}

}  // namespace
}  // namespace lamella::surgery
