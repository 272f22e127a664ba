#include "picture/view.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include <gtest/gtest.h>

#include "picture/camera.h"
#include "picture/scenes.h"

namespace lamella::picture {
namespace {

using film::Vec3;

void expect_near(const Vec3& a, const Vec3& b) {
  EXPECT_LT(length(a - b), 1e-12) << a.x << " " << a.y << " " << a.z;
}

TEST(View, LookingFromASideHasZUp) {
  const Axes front = axes(looking_from({0, -2, 0}));
  expect_near(front[0], {1, 0, 0});
  expect_near(front[1], {0, 0, 1});
  expect_near(front[2], {0, -1, 0});
  const Vec3 from = unit(Vec3{0.3, -0.8, 0.5});
  const Axes oblique = axes(looking_from(from));
  expect_near(oblique[2], from);
  EXPECT_NEAR(oblique[0].z, 0, 1e-12);
  EXPECT_GT(oblique[1].z, 0);
}

TEST(View, LookingFromAboveHasXOrYUp) {
  const Axes top = axes(looking_from({0, 0, 1}));
  expect_near(top[2], {0, 0, 1});
  expect_near(cross(top[0], top[1]), top[2]);
}

TEST(View, RotationsCombine) {
  const Axes turned = axes(about({0, 0, 1}, M_PI / 2) * about({1, 0, 0}, M_PI / 2));
  // First y goes to z, then x to y: the axes are the rows of that product.
  expect_near(turned[0], {0, 0, 1});
  expect_near(turned[1], {1, 0, 0});
  expect_near(turned[2], {0, 1, 0});
}

TEST(View, AFilmInThePlaneIsSeenFromAbove) {
  scene::Scene scene;
  scene.strings.on = true;
  scene.strings.dimension = 2;
  const View view = view_of(scene);
  EXPECT_EQ(view.rotation, Rotation{});
  EXPECT_EQ(view.field_of_view, 0);
}

// The angle between the line of sight and a plane film, whatever its direction, is no glancing one.
TEST(View, NoFlatFilmIsSeenEdgeOn) {
  for (const Vec3 normal :
       {Vec3{0, 0, 1}, Vec3{0, 1, 0}, Vec3{1, 0, 0}, Vec3{1, -1, 1}, Vec3{2, 1, 0}, Vec3{1, 2, 3}}) {
    const Vec3 u = unit(cross(normal, Vec3{0.3, 0.5, -0.7}));
    const Vec3 v = unit(cross(normal, u));
    scenes::Builder b;
    b.patch(-u - v, u - v, u + v, v - u, 3);
    const Axes seen = axes(view_of(b.finish()).rotation);
    EXPECT_GT(std::abs(dot(seen[2], unit(normal))), 0.3) << normal.x << normal.y << normal.z;
    EXPECT_GT(seen[2].z, 0.2);
    EXPECT_LT(seen[2].z, 0.6);
  }
}

class Framing : public ::testing::TestWithParam<std::tuple<double, double>> {};

TEST_P(Framing, ContainsAllPointsUpToTheMargin) {
  const auto [field_of_view, aspect] = GetParam();
  std::vector<Point> points;
  for (int i = 0; i < 200; ++i) {
    const double t = 0.37 * i;
    points.push_back({static_cast<float>(std::cos(t) + 3), static_cast<float>(0.4 * std::sin(2.1 * t)),
                      static_cast<float>(0.7 * std::sin(0.9 * t) - 1)});
  }
  View view;
  view.rotation = looking_from({1, -2, 0.7});
  view.field_of_view = field_of_view;
  const Camera camera = fit_camera(points, 1e-9, view, aspect);
  double left = 1;
  double right = -1;
  double bottom = 1;
  double top = -1;
  for (const Point& p : points) {
    const Vec3 seen = camera.project({p[0], p[1], p[2]});
    left = std::min(left, seen.x);
    right = std::max(right, seen.x);
    bottom = std::min(bottom, seen.y);
    top = std::max(top, seen.y);
    EXPECT_GT(seen.z, 0.999 * camera.nearest);
    EXPECT_LT(seen.z, 1.001 * camera.farthest);
  }
  const double free = 2 * margin;
  const double reach = std::max({-left, right, -bottom, top});
  EXPECT_NEAR(reach, 1 - free, 1e-6);  // as large as can be
  const bool wide = right > top;
  EXPECT_NEAR(wide ? left : bottom, free - 1, 1e-6);  // in the middle
  EXPECT_GT(camera.nearest, 0);
}

INSTANTIATE_TEST_SUITE_P(Views, Framing,
                         ::testing::Combine(::testing::Values(0.0, 26.0, 90.0),
                                            ::testing::Values(0.4, 1.0, 4.0 / 3, 5.0)));

TEST(Camera, ZoomAndOffsetActOnThePicture) {
  const std::vector<Point> points = {{-1, -1, -1}, {1, 1, 1}, {1, -1, 0}};
  View view;
  const Camera plain = fit_camera(points, 0.01, view, 2);
  view.zoom = 3;
  view.right = 0.25;
  view.up = -0.5;
  const Camera moved = fit_camera(points, 0.01, view, 2);
  const Vec3 a = plain.project({0.2, 0.1, 0.3});
  const Vec3 b = moved.project({0.2, 0.1, 0.3});
  EXPECT_NEAR(b.x, 3 * a.x + 0.25, 1e-12);
  EXPECT_NEAR(b.y, 3 * a.y - 1.0, 1e-12);
}

}  // namespace
}  // namespace lamella::picture
