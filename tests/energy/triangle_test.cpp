#include "energy/triangle.h"

#include <random>

#include <gtest/gtest.h>

#include "energy/gravity.h"
#include "energy/sweep.h"
#include "support/differences.h"

namespace lamella::energy {
namespace {

std::vector<Vec3> random_triangle(std::mt19937& random) {
  std::uniform_real_distribution<double> u(-1, 1);
  std::vector<Vec3> p;
  for (int i = 0; i < 3; ++i) p.push_back({u(random), u(random), u(random)});
  return p;
}

template <class Value, class Gradient>
void expect_gradient(Value&& value, Gradient&& gradient) {
  std::mt19937 random(11);
  for (int round = 0; round < 200; ++round) {
    const std::vector<Vec3> p = random_triangle(random);
    if (triangle_area(p[0], p[1], p[2]) < 0.05) continue;
    const auto g = gradient(p[0], p[1], p[2]);
    const auto d =
        test::gradient_by_differences(p, [&](const std::vector<Vec3>& x) { return value(x[0], x[1], x[2]); });
    for (std::size_t k = 0; k < 3; ++k) EXPECT_LT(length(g[k] - d[k]), 1e-7) << "round " << round;
  }
}

TEST(Triangle, AreaOfARightTriangle) {
  EXPECT_DOUBLE_EQ(triangle_area({1, 1, 1}, {4, 1, 1}, {1, 5, 1}), 6);
}

TEST(Triangle, AreaGradientAgreesWithDifferences) {
  expect_gradient(triangle_area, triangle_area_gradient);
}

TEST(Triangle, AreaGradientKeepsPlaceAndTurn) {
  std::mt19937 random(3);
  for (int round = 0; round < 100; ++round) {
    const std::vector<Vec3> p = random_triangle(random);
    const auto g = triangle_area_gradient(p[0], p[1], p[2]);
    EXPECT_LT(length(g[0] + g[1] + g[2]), 1e-14);
    EXPECT_LT(length(cross(p[0], g[0]) + cross(p[1], g[1]) + cross(p[2], g[2])), 1e-14);
    // Euler: area is homogeneous of degree two.
    EXPECT_NEAR(dot(p[0], g[0]) + dot(p[1], g[1]) + dot(p[2], g[2]), 2 * triangle_area(p[0], p[1], p[2]),
                1e-14);
  }
}

TEST(Triangle, NoAreaNoGradient) {
  for (const Vec3& g : triangle_area_gradient({0, 0, 0}, {1, 1, 1}, {2, 2, 2})) EXPECT_EQ(g, Vec3{});
}

TEST(Triangle, VolumeGradientAgreesWithDifferences) {
  expect_gradient(sixfold_volume, [](const Vec3& a, const Vec3& b, const Vec3& c) {
    return sixfold_volume_gradient(a, b, c);
  });
  EXPECT_DOUBLE_EQ(sixfold_volume({1, 0, 0}, {0, 1, 0}, {0, 0, 1}), 1);
}

TEST(Gravity, HeightIntegralAgreesWithDifferencesAndAPrism) {
  expect_gradient(height_integral, height_integral_gradient);
  // Top minus bottom of a prism over the triangle (0,0)(1,0)(0,1) between z = 1 and z = 3: integral of z is
  // 1/2 * (9-1)/2.
  const double top = height_integral({0, 0, 3}, {1, 0, 3}, {0, 1, 3});
  const double bottom = height_integral({0, 0, 1}, {0, 1, 1}, {1, 0, 1});
  EXPECT_DOUBLE_EQ(top + bottom, 2);
}

// The largest eigenvalue of the 3x3 cotangent stiffness, by the closed form and by power iteration.
TEST(Sweep, StiffnessBoundIsTheLargestEigenvalue) {
  std::mt19937 random(9);
  for (int round = 0; round < 100; ++round) {
    const std::vector<Vec3> p = random_triangle(random);
    const double area = triangle_area(p[0], p[1], p[2]);
    double k[3][3];
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        const Vec3 ei = p[(i + 2) % 3] - p[(i + 1) % 3];
        const Vec3 ej = p[(j + 2) % 3] - p[(j + 1) % 3];
        k[i][j] = dot(ei, ej) / (4 * area);
      }
    }
    double v[3] = {1, -0.3, 0.2};
    double eigenvalue = 0;
    for (int it = 0; it < 20000; ++it) {
      double w[3] = {};
      for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) w[i] += k[i][j] * v[j];
      }
      eigenvalue = std::sqrt(w[0] * w[0] + w[1] * w[1] + w[2] * w[2]);
      for (int i = 0; i < 3; ++i) v[i] = w[i] / eigenvalue;
    }
    EXPECT_NEAR(stiffness_bound(p[0], p[1], p[2]) / eigenvalue, 1, 1e-6) << "round " << round;
  }
}

}  // namespace
}  // namespace lamella::energy
