#include "film/film.h"

#include <random>

#include <gtest/gtest.h>

#include "film/check.h"
#include "film/order.h"
#include "support/shapes.h"

namespace lamella::film {
namespace {

using test::Builder;

void expect_sound(const Film& film) {
  const std::vector<std::string> found = check(film);
  EXPECT_TRUE(found.empty()) << found[0];
}

TEST(Film, CubeHasItsElements) {
  const scene::Scene scene = test::cube();
  EXPECT_EQ(scene.film.vertex_count(), 14U);
  EXPECT_EQ(scene.film.edge_count(), 36U);
  EXPECT_EQ(scene.film.triangle_count(), 24U);
  expect_sound(scene.film);
  EXPECT_TRUE(check_regions(scene.film).empty());
}

TEST(Film, ValenceTellsWiresRimsFilmsAndBorders) {
  Builder b;
  std::vector<Vertex> v;
  for (int i = 0; i < 5; ++i) v.push_back(b.vertex({std::cos(2.0 * i), std::sin(2.0 * i), 0.3 * i}));
  const SignedEdge border = b.edge(v[0], v[1]);
  const SignedEdge wire = b.edge(v[3], v[4]);
  b.triangle(v[0], v[1], v[2]);
  b.triangle(v[0], v[1], v[3]);
  b.triangle(v[1], v[0], v[4]);
  b.film.sort_all_sides();
  EXPECT_EQ(b.film.valence(border.edge()), 3);
  EXPECT_EQ(b.film.valence(wire.edge()), 0);
  EXPECT_EQ(b.film.valence(b.edge(v[0], v[2]).edge()), 1);
  expect_sound(b.film);
}

// Sides put in random order must come out counterclockwise about the edge.
TEST(Film, SortsSidesAroundABorder) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> angle(0, 2 * M_PI);
  for (int round = 0; round < 50; ++round) {
    Builder b;
    const Vertex p = b.vertex({0, 0, 0});
    const Vertex q = b.vertex({0, 0, 1});
    std::vector<double> angles;
    for (int i = 0; i < 6; ++i) {
      angles.push_back(angle(random));
      const Vertex r = b.vertex({std::cos(angles.back()), std::sin(angles.back()), 0.5});
      round % 2 == 0 ? b.triangle(p, q, r) : b.triangle(q, p, r);
    }
    b.film.sort_all_sides();
    const Edge e = b.edge(p, q).edge();
    int turns = 0;
    b.film.for_each_side(e, [&](Side s) {
      const double here = angles[s.triangle().index];
      const double next = angles[b.film.next_around(s).triangle().index];
      turns += next < here ? 1 : 0;
    });
    // In the odd rounds the edge runs from q to p, and counterclockwise about it is clockwise here.
    EXPECT_EQ(turns, round % 2 == 0 ? 1 : 5);
    expect_sound(b.film);
  }
}

TEST(Film, CheckSeesSidesOutOfOrder) {
  Builder b;
  const Vertex p = b.vertex({0, 0, 0});
  const Vertex q = b.vertex({0, 0, 1});
  std::vector<Side> sides;
  for (int i = 0; i < 4; ++i) {
    sides.emplace_back(b.triangle(p, q, b.vertex({std::cos(1.5 * i), std::sin(1.5 * i), 0.5})), 0);
  }
  b.film.sort_all_sides();
  expect_sound(b.film);
  std::swap(sides[1], sides[2]);
  b.film.set_ring(b.edge(p, q).edge(), sides);
  ASSERT_EQ(check(b.film).size(), 1U);
  EXPECT_NE(check(b.film)[0].find("geometric order"), std::string::npos);
}

TEST(Film, CheckSeesBrokenReferences) {
  scene::Scene scene = test::cube();
  scene.film.edit_connectivity().edge_side[3] = Side(Triangle(20U), 0);
  EXPECT_FALSE(check(scene.film).empty());
  scene = test::cube();
  scene.film.edit_connectivity().triangle_vertices[2][1] = Vertex(0U);
  EXPECT_FALSE(check(scene.film).empty());
  scene = test::cube();
  scene.film.edit_connectivity().next_end[5][0] = EdgeEnd(Edge(5U), 0);
  EXPECT_FALSE(check(scene.film).empty());
  scene = test::cube();
  scene.film.move(Vertex(3U), {0, NAN, 0});
  EXPECT_FALSE(check(scene.film).empty());
}

// Around each edge of a labelled foam the sector between two neighbouring sides carries one region.
TEST(Film, RandomFoamsAreSoundAndConsistentlyLabelled) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    const scene::Scene scene = test::random_foam(seed);
    expect_sound(scene.film);
    const auto found = check_regions(scene.film);
    EXPECT_TRUE(found.empty()) << "seed " << seed << ": " << found[0];
  }
}

TEST(Film, CheckRegionsSeesAWrongLabel) {
  scene::Scene scene = test::cube();
  scene.film.set_regions(Triangle(4U), {Region{1}, Region{0}});
  EXPECT_EQ(check_regions(scene.film).size(), 6U);  // twice at each of its three edges
}

TEST(Film, RemovalLeavesASoundFilmAndCompactionKeepsNumbers) {
  scene::Scene scene = test::random_foam(3);
  Film& film = scene.film;
  std::mt19937 random(1);
  const std::uint32_t before = film.triangle_count();
  for (std::uint32_t t = 0; t < film.triangle_rows(); ++t) {
    if (random() % 3 == 0) film.remove(Triangle(t));
  }
  for (std::uint32_t e = 0; e < film.edge_rows(); ++e) {
    if (!film.first_side(Edge(e)).valid()) film.remove(Edge(e));
  }
  for (std::uint32_t v = 0; v < film.vertex_rows(); ++v) {
    if (!film.first_end(Vertex(v)).valid()) film.remove(Vertex(v));
  }
  expect_sound(film);
  std::vector<std::pair<std::uint32_t, Vec3>> kept;
  for (std::uint32_t v = 0; v < film.vertex_rows(); ++v) {
    if (film.alive(Vertex(v))) kept.emplace_back(film.number(Vertex(v)), film.position(Vertex(v)));
  }
  ASSERT_LT(film.triangle_count(), before);
  film.compact();
  EXPECT_TRUE(film.is_compact());
  expect_sound(film);
  ASSERT_EQ(film.vertex_rows(), kept.size());
  for (const auto& [number, position] : kept) {
    const Vertex v = film.vertex_numbered(number);
    ASSERT_TRUE(v.valid());
    EXPECT_EQ(film.position(v), position);
    EXPECT_EQ(film.number(v), number);
  }
  EXPECT_FALSE(film.vertex_numbered(100000).valid());
}

// After removals and compaction, as in a film whose rows were added one after another.
TEST(Film, RingsThatBeginAlikeFollowFromRows) {
  Film film = test::random_foam(5).film;
  for (std::uint32_t t = 0; t < film.triangle_rows(); t += 7) film.remove(Triangle(t));
  film.compact();
  film.begin_rings_alike();
  Film again;
  for (const Vec3& p : film.positions()) again.add_vertex(p);
  for (std::uint32_t e = 0; e < film.edge_rows(); ++e) {
    const auto ends = film.ends(Edge(e));
    again.add_edge(ends[0], ends[1]);
  }
  const auto ends_at = [](const Film& of, std::uint32_t v) {
    std::vector<EdgeEnd> list;
    of.for_each_end(Vertex(v), [&](EdgeEnd end) { list.push_back(end); });
    return list;
  };
  for (std::uint32_t v = 0; v < film.vertex_rows(); ++v) EXPECT_EQ(ends_at(film, v), ends_at(again, v)) << v;
  for (std::uint32_t e = 0; e < film.edge_rows(); ++e) {
    film.for_each_side(Edge(e), [&](Side s) { EXPECT_LE(film.first_side(Edge(e)), s) << e; });
  }
  expect_sound(film);
}

TEST(Film, NewElementsGetNumbersAboveAllOthers) {
  scene::Scene scene = test::cube();
  scene.film.remove(Triangle(0U));
  scene.film.compact();
  EXPECT_EQ(scene.film.number(Triangle(0U)), 2U);
  EXPECT_EQ(scene.film.number(scene.film.add_vertex({5, 5, 5})), 15U);
  Film& film = scene.film;
  const auto e = film.edges(Triangle(0U));
  const Triangle made = film.add_triangle({-e[2], -e[1], -e[0]}, {});
  EXPECT_EQ(film.number(made), 25U);
  EXPECT_EQ(film.triangle_numbered(25), made);
}

TEST(Film, SpatialOrderKeepsEverythingButRows) {
  scene::Scene scene = test::random_foam(8, 5, 6);
  Film& film = scene.film;
  Column heat = real_column("heat");
  film.columns(ElementKind::vertex).add(heat);
  for (std::uint32_t v = 0; v < film.vertex_rows(); ++v)
    film.columns(ElementKind::vertex).edit("heat")->set(v, 0, film.position(Vertex(v)).x);
  // Shuffle, then order.
  std::mt19937 random(2);
  const auto shuffled = [&](std::uint32_t rows) {
    std::vector<std::uint32_t> order(rows);
    for (std::uint32_t i = 0; i < rows; ++i) order[i] = i;
    std::shuffle(order.begin(), order.end(), random);
    return order;
  };
  const Film original = film;
  film.renumber(shuffled(film.vertex_rows()), shuffled(film.edge_rows()), shuffled(film.triangle_rows()));
  expect_sound(film);
  const double scattered = mean_row_distance(film);
  restore_spatial_order(film);
  expect_sound(film);
  EXPECT_LT(mean_row_distance(film), 0.5 * scattered);
  for (std::uint32_t n = 1; n <= original.vertex_rows(); ++n) {
    const Vertex v = film.vertex_numbered(n);
    EXPECT_EQ(film.position(v), original.position(original.vertex_numbered(n)));
    EXPECT_EQ(film.columns(ElementKind::vertex).find("heat")->value(v.index), film.position(v).x);
  }
  for (std::uint32_t n = 1; n <= original.triangle_rows(); ++n) {
    const Triangle t = film.triangle_numbered(n);
    const Triangle o = original.triangle_numbered(n);
    EXPECT_EQ(film.regions(t), original.regions(o));
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_EQ(film.number(film.corners(t)[k]), original.number(original.corners(o)[k]));
      EXPECT_EQ(film.number(film.edges(t)[k].edge()), original.number(original.edges(o)[k].edge()));
      EXPECT_EQ(film.edges(t)[k].reversed(), original.edges(o)[k].reversed());
    }
  }
}

TEST(Film, CopiesShareUntilEdited) {
  scene::Scene scene = test::cube();
  const Film copy = scene.film;
  EXPECT_EQ(copy.positions().data(), scene.film.positions().data());
  EXPECT_EQ(copy.position_revision(), scene.film.position_revision());
  scene.film.move(Vertex(0U), {9, 9, 9});
  EXPECT_NE(copy.position(Vertex(0U)), scene.film.position(Vertex(0U)));
  EXPECT_NE(copy.position_revision(), scene.film.position_revision());
  EXPECT_EQ(copy.connectivity_revision(), scene.film.connectivity_revision());
}

// The promise of the data model: 100 bytes a triangle on a closed film, where there are 1.5 edges and half a
// vertex each.
TEST(Film, TakesAtMostAHundredBytesATriangle) {
  Builder b;
  const std::uint32_t n = 60;
  std::vector<Vertex> v;
  for (std::uint32_t i = 0; i < n * n; ++i) v.push_back(b.vertex({double(i % n), double(i / n), 0}));
  const auto at = [&](std::uint32_t i, std::uint32_t j) { return v[(i % n) * n + j % n]; };
  for (std::uint32_t i = 0; i < n; ++i) {
    for (std::uint32_t j = 0; j < n; ++j) {
      b.triangle(at(i, j), at(i + 1, j), at(i + 1, j + 1));
      b.triangle(at(i, j), at(i + 1, j + 1), at(i, j + 1));
    }
  }
  ASSERT_EQ(b.film.triangle_count(), 2 * n * n);
  EXPECT_EQ(b.film.bytes(), 88U * b.film.triangle_count());
}

}  // namespace
}  // namespace lamella::film
