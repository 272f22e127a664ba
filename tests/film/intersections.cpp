#include "film/intersections.h"

#include <random>

#include <gtest/gtest.h>

#include "film/box_tree.h"
#include "film/predicates.h"
#include "support/shapes.h"

namespace lamella::film {
namespace {

TEST(Predicates, SignsOfOrientation) {
  EXPECT_EQ(orientation({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, -1}), 1);
  EXPECT_EQ(orientation({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}), -1);
  EXPECT_EQ(orientation({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {7, -3, 0}), 0);
}

// Points of a plane in general position whose coordinates are dyadic, so that the plane is met exactly, and
// the same lifted by one unit in the last place.
TEST(Predicates, ExactWhereRoundingDecides) {
  std::mt19937 random(5);
  std::uniform_int_distribution<int> number(-(1 << 20), 1 << 20);
  for (int i = 0; i < 2000; ++i) {
    const auto point = [&] {
      const double x = number(random) / 1048576.0;
      const double y = number(random) / 1048576.0;
      return Vec3{x, y, 0.5 * x - 0.25 * y + 1};
    };
    const Vec3 a = point(), b = point(), c = point(), d = point();
    EXPECT_EQ(orientation(a, b, c, d), 0);
    const int turn = orientation_along(2, a, b, c);
    const Vec3 above{d.x, d.y, std::nextafter(d.z, 10)};
    const Vec3 below{d.x, d.y, std::nextafter(d.z, -10)};
    EXPECT_EQ(orientation(a, b, c, above), -turn);
    EXPECT_EQ(orientation(a, b, c, below), turn);
  }
}

TEST(Predicates, SignDoesNotDependOnTheOrderOfPoints) {
  std::mt19937 random(6);
  std::uniform_real_distribution<double> noise(-1e-16, 1e-16);
  for (int i = 0; i < 500; ++i) {
    const auto point = [&](double t) { return Vec3{t + noise(random), 2 * t + noise(random), 3 * t + 1}; };
    const Vec3 a = point(0.1), b = point(0.2), c = point(0.3), d = point(0.7);
    const int sign = orientation(a, b, c, d);
    EXPECT_EQ(orientation(b, c, a, d), sign);
    EXPECT_EQ(orientation(b, a, c, d), -sign);
    EXPECT_EQ(orientation(a, b, d, c), -sign);
  }
}

TEST(Predicates, SegmentMeetsTriangle) {
  const Vec3 a{0, 0, 0}, b{1, 0, 0}, c{0, 1, 0};
  EXPECT_TRUE(segment_meets_triangle({0.2, 0.2, -1}, {0.2, 0.2, 1}, a, b, c));
  EXPECT_FALSE(segment_meets_triangle({0.8, 0.8, -1}, {0.8, 0.8, 1}, a, b, c));
  EXPECT_FALSE(segment_meets_triangle({0.2, 0.2, 0.1}, {0.2, 0.2, 1}, a, b, c));
  EXPECT_TRUE(segment_meets_triangle({0.2, 0.2, 0}, {0.2, 0.2, 1}, a, b, c));   // touches
  EXPECT_TRUE(segment_meets_triangle({0.5, 0.5, -1}, {0.5, 0.5, 1}, a, b, c));  // a side
  EXPECT_TRUE(segment_meets_triangle({-1, 0.2, 0}, {2, 0.2, 0}, a, b, c));      // in its plane
  EXPECT_FALSE(segment_meets_triangle({-1, -0.2, 0}, {2, -0.2, 0}, a, b, c));
}

TEST(BoxTree, FindsAllThatMeet) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(0, 1);
  std::vector<Box> boxes;
  for (int i = 0; i < 500; ++i) {
    const Vec3 p{place(random), place(random), place(random)};
    boxes.push_back({p, p + Vec3{0.1 * place(random), 0.1 * place(random), 0.1 * place(random)}});
  }
  const BoxTree tree(boxes);
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    std::size_t met = 0;
    tree.for_each_met(boxes[i], [&](std::uint32_t) { ++met; });
    std::size_t expected = 0;
    for (const Box& other : boxes) expected += other.meets(boxes[i]) ? 1U : 0U;
    EXPECT_EQ(met, expected);
  }
}

TEST(Intersections, NoneInSoundFilms) {
  EXPECT_TRUE(self_intersections(test::cube().film).empty());
  EXPECT_TRUE(self_intersections(test::square_film(8).film).empty());
  for (unsigned seed = 0; seed < 5; ++seed)
    EXPECT_TRUE(self_intersections(test::random_foam(seed).film).empty()) << seed;
}

TEST(Intersections, FoundWhereSheetsCross) {
  test::Builder b;
  const Vertex p = b.vertex({0, 0, 0}), q = b.vertex({1, 0, 0}), r = b.vertex({0, 1, 0});
  const Triangle flat = b.triangle(p, q, r);
  const Vertex u = b.vertex({0.2, 0.2, -1}), v = b.vertex({0.3, 0.2, 1}), w = b.vertex({2, 2, 1});
  const Triangle through = b.triangle(u, v, w);
  ASSERT_EQ(self_intersections(b.film).size(), 1U);
  EXPECT_TRUE(facets_cross(b.film, flat, through));
  // With a corner in common: the side opposite to it passes through.
  const Triangle from_corner = b.triangle(p, u, v);
  EXPECT_TRUE(facets_cross(b.film, flat, from_corner));
  EXPECT_FALSE(facets_cross(b.film, through, from_corner));
}

TEST(Intersections, AFlatFoldIsOne) {
  test::Builder b;
  const Vertex p = b.vertex({0, 0, 0}), q = b.vertex({1, 0, 0});
  b.triangle(p, q, b.vertex({0.3, 1, 0}));
  b.triangle(q, p, b.vertex({0.4, 0.5, 0}));
  EXPECT_EQ(self_intersections(b.film).size(), 1U);
}

}  // namespace
}  // namespace lamella::film
