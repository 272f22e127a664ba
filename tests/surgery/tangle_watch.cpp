#include "surgery/tangle_watch.h"

#include <gtest/gtest.h>

#include "support/random_motion.h"
#include "surgery/facet_gap.h"
#include "surgery/remesh.h"
#include "surgery/sizing.h"

namespace lamella::surgery {
namespace {

using film::Film;
using film::Vec3;
using film::Vertex;

// Two flat squares of side 1, one above the other.
Film two_sheets(int n, double gap) {
  test::Builder b;
  for (const double z : {0.0, gap}) {
    std::vector<Vertex> v;
    for (int i = 0; i <= n; ++i) {
      for (int j = 0; j <= n; ++j) v.push_back(b.vertex({double(i) / n, double(j) / n, z}));
    }
    const auto at = [&](int i, int j) { return v[std::size_t(i * (n + 1) + j)]; };
    for (int i = 0; i < n; ++i) {
      for (int j = 0; j < n; ++j) {
        b.triangle(at(i, j), at(i + 1, j), at(i + 1, j + 1));
        b.triangle(at(i, j), at(i + 1, j + 1), at(i, j + 1));
      }
    }
  }
  b.film.sort_all_sides();
  return std::move(b.film);
}

void move_upper(Film& film, const Vec3& by) {
  const std::uint32_t half = film.vertex_rows() / 2;
  for (std::uint32_t v = half; v < film.vertex_rows(); ++v)
    film.move(Vertex(v), film.position(Vertex(v)) + by);
}

TEST(TangleWatch, OfAFilmAtRestNothingIsLookedAtTwice) {
  Film film = two_sheets(8, 0.3);
  TangleWatch watch;
  EXPECT_TRUE(watch.look(film).empty());
  const long all = watch.looked_at();
  EXPECT_EQ(all, 2 * film.triangle_count());
  for (int i = 0; i < 10; ++i) EXPECT_TRUE(watch.look(film).empty());
  EXPECT_EQ(watch.looked_at(), all);
  move_upper(film, {0, 0, 0.01});
  EXPECT_TRUE(watch.look(film).empty());
  EXPECT_EQ(watch.looked_at(), all);
}

TEST(TangleWatch, SeesSheetsThatComeToCross) {
  Film film = two_sheets(8, 0.3);
  TangleWatch watch;
  watch.look(film);
  for (std::uint32_t v = film.vertex_rows() / 2; v < film.vertex_rows(); ++v) {
    const Vec3 p = film.position(Vertex(v));
    film.move(Vertex(v), {p.x, p.y, p.z - 0.7 * p.x + 0.013 * p.y});
  }
  EXPECT_FALSE(watch.look(film).empty());
  EXPECT_FALSE(watch.look(film).empty()) << "it is still so";
}

// Neither the first film nor the last passes through itself: it has done so between.
// Where a film tangles that was never seen before, it goes back to a place that the watch does not know.
TEST(TangleWatch, GoesOnFromNowhereThatTangles) {
  Film film = two_sheets(8, -0.03);
  const Vertex one(film.vertex_rows() - 20);
  film.move(one, film.position(one) + Vec3{0.09, 0.05, 0.1});
  TangleWatch watch;
  EXPECT_FALSE(watch.look(film).empty());
  film.move(one, film.position(one) - Vec3{0.09, 0.05, 0.1});
  EXPECT_TRUE(watch.look(film).empty());
}

TEST(TangleWatch, SeesASheetThatHasPassedThroughAnother) {
  Film film = two_sheets(4, 0.1);
  TangleWatch watch;
  EXPECT_TRUE(watch.look(film).empty());
  move_upper(film, {0.03, 0.02, -0.2});
  EXPECT_TRUE(tangles(film).empty());
  EXPECT_FALSE(watch.look(film).empty());
  move_upper(film, {-0.03, -0.02, 0.2});
  EXPECT_TRUE(watch.look(film).empty()) << "it has gone back to where it was";
  watch.forget();
  move_upper(film, {0.03, 0.02, -0.2});
  EXPECT_TRUE(watch.look(film).empty()) << "how it came there does not count";
}

// Whatever the whole search finds the watch finds, in random scenes whose vertices wander.
TEST(TangleWatch, MissesNothingThatTheWholeSearchFinds) {
  int tangled = 0;
  long looked_at = 0;
  long facets = 0;
  for (std::uint32_t seed = 0; seed < 12; ++seed) {
    test::Chance chance(seed);
    Film film = test::random_bubbles(seed, 6).film;
    film.compact();
    TangleWatch watch;
    std::vector<Vec3> velocity(film.vertex_rows());
    for (Vec3& v : velocity) v = chance.vector(0.004);
    for (int step = 0; step < 40; ++step) {
      for (std::uint32_t v = 0; v < velocity.size(); ++v)
        film.move(Vertex(v), film.position(Vertex(v)) + velocity[v]);
      const bool whole = !tangles(film).empty();
      const bool watched = !watch.look(film).empty();
      facets += film.triangle_count();
      if (whole) {
        EXPECT_TRUE(watched) << "scene " << seed << ", step " << step;
        ++tangled;
        break;
      }
    }
    looked_at += watch.looked_at();
  }
  EXPECT_GE(tangled, 6);
  EXPECT_LT(looked_at, facets) << "less than half: each facet counts for its edges and for its way";
}

// A sheet that was flat folds up: its halves come to face one another, next to the crease, too, where every
// vertex of one is an edge away from the other.
TEST(TangleWatch, ListsWhatFacesAcrossAFoldThatWasFlat) {
  const int n = 8;
  Film film = two_sheets(n, 9);
  TangleWatch watch;
  std::vector<Vec3> flat(film.positions().begin(), film.positions().end());
  for (int step = 0; step <= 3; ++step) {
    const double turn = step * 26 * M_PI / 180;
    for (std::uint32_t v = 0; v < flat.size() / 2; ++v) {
      const double way = flat[v].x - 0.5;
      film.move(Vertex(v), {way * std::cos(turn), flat[v].y, std::abs(way) * std::sin(turn)});
    }
    EXPECT_TRUE(watch.look(film).empty());
  }
  // Facets at the crease, and a column away from it on the other side.
  const auto place = [&](film::Triangle t) {
    const Corners p = film.points(t);
    const auto [low, high] = std::minmax({p[0].x, p[1].x, p[2].x});
    return std::pair(low + high, std::min(std::abs(low), std::abs(high)) < 1e-9);
  };
  const auto are_joined = [&](film::Triangle t, film::Triangle other) {
    bool joined = false;
    const auto& corners = film.corners(other);
    for (const Vertex v : film.corners(t)) {
      film.for_each_end(v, [&](film::EdgeEnd end) {
        joined =
            joined || std::find(corners.begin(), corners.end(), film.head(end.outward())) != corners.end();
      });
    }
    return joined;
  };
  int facing = 0;
  for (const FacetPair& pair : watch.near_pairs()) {
    const auto [a, a_at_crease] = place(pair.a);
    const auto [b, b_at_crease] = place(pair.b);
    facing += a * b < 0 && a_at_crease != b_at_crease && are_joined(pair.a, pair.b) ? 1 : 0;
  }
  EXPECT_GT(facing, 8 * n) << "rims alone give half of that";
}

// What surgery leaves alone is not looked at again.
TEST(TangleWatch, FollowsSurgery) {
  scene::Scene scene = test::random_bubbles(1, 4);
  Film& film = scene.film;
  film.compact();
  keep_sizes(film);
  TangleWatch watch;
  EXPECT_TRUE(watch.look(film).empty());
  const long before = watch.looked_at();
  film::Edge longest(0U);
  const auto square = [&](film::Edge e) { return squared_length(film.vector(film::SignedEdge(e, false))); };
  for (std::uint32_t e = 1; e < film.edge_rows(); ++e) {
    if (square(film::Edge(e)) > square(longest)) longest = film::Edge(e);
  }
  const RemeshReport report =
      remesh(scene, {.longest = 0.99 * std::sqrt(square(longest)) / size_of(film, longest)});
  ASSERT_GT(report.operations(), 0);
  watch.before_compaction(film);
  film.compact();
  EXPECT_TRUE(watch.look(film).empty());
  EXPECT_GT(watch.looked_at(), before);
  EXPECT_LT(watch.looked_at(), 2 * before);
}

TEST(FacetGap, IsNoMoreThanTheDistance) {
  test::Chance chance(3);
  int apart = 0;
  for (int i = 0; i < 2000; ++i) {
    Corners a;
    Corners b;
    for (std::size_t k = 0; k < 3; ++k) {
      a[k] = chance.vector(1);
      b[k] = chance.vector(1) + Vec3{1.5, 0, 0};
    }
    const double least = gap_at_least(a, b);
    EXPECT_LE(least, distance(a, b) + 1e-12);
    apart += least > 0 ? 1 : 0;
  }
  EXPECT_GT(apart, 1000);
}

TEST(FacetGap, DistanceOfTrianglesInKnownPlaces) {
  const Corners flat{Vec3{0, 0, 0}, Vec3{1, 0, 0}, Vec3{0, 1, 0}};
  EXPECT_DOUBLE_EQ(distance(flat, {Vec3{0.2, 0.2, 0.5}, Vec3{2, 0, 2}, Vec3{0, 2, 2}}), 0.5);
  EXPECT_DOUBLE_EQ(distance(flat, {Vec3{-1, -0.5, 1}, Vec3{-1, -0.5, -1}, Vec3{-9, -3, 0}}),
                   std::hypot(1, 0.5));
  EXPECT_NEAR(distance(flat, {Vec3{0.5, -0.25, 1}, Vec3{0.5, -0.25, -1}, Vec3{0.5, -3, 0}}), 0.25, 1e-15);
}

TEST(FacetGap, TrianglesThatMeetOnTheWay) {
  const Corners flat{Vec3{0, 0, 0}, Vec3{1, 0, 0}, Vec3{0, 1, 0}};
  const Corners above{Vec3{0.1, 0.1, 0.2}, Vec3{0.9, 0.2, 0.3}, Vec3{0.1, 0.8, 0.2}};
  Corners below = above;
  Corners aside = above;
  for (std::size_t k = 0; k < 3; ++k) {
    below[k].z -= 1;
    aside[k] += Vec3{3, 0, -1};
  }
  EXPECT_TRUE(meet_on_the_way(flat, flat, above, below));
  EXPECT_FALSE(meet_on_the_way(flat, flat, above, above));
  EXPECT_FALSE(meet_on_the_way(flat, flat, below, below));
  EXPECT_FALSE(meet_on_the_way(below, below, above, aside));
  // Together they may go any way.
  Corners down = flat;
  for (Vec3& p : down) p.z -= 1;
  EXPECT_FALSE(meet_on_the_way(flat, down, above, below));
}

}  // namespace
}  // namespace lamella::surgery
