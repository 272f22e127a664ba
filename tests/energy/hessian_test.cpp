#include <functional>
#include <random>

#include <gtest/gtest.h>

#include "energy/gravity.h"
#include "energy/open_rim.h"
#include "energy/triangle_hessian.h"

namespace lamella::energy {
namespace {

using Corners = std::array<Vec3, 3>;
using Gradient = std::function<Corners(const Vec3&, const Vec3&, const Vec3&)>;

Corners random_corners(std::mt19937& random) {
  std::uniform_real_distribution<double> u(-1, 1);
  Corners p;
  for (Vec3& corner : p) corner = {u(random), u(random), u(random)};
  return p;
}

double largest(const Mat3& a) {
  double worst = 0;
  for (const Vec3& row : {a.x, a.y, a.z}) worst = std::fmax(worst, length(row));
  return worst;
}

// d(gradient i)/d(corner j) by central differences of fourth order: column by column.
Mat3 difference_block(const Gradient& gradient, Corners p, std::size_t i, std::size_t j) {
  constexpr double h = 1e-3;
  Mat3 columns;
  for (int axis = 0; axis < 3; ++axis) {
    const double at = p[j][axis];
    const auto value = [&](double step) {
      p[j][axis] = at + step * h;
      const Vec3 g = gradient(p[0], p[1], p[2])[i];
      p[j][axis] = at;
      return g;
    };
    (axis == 0   ? columns.x
     : axis == 1 ? columns.y
                 : columns.z) = (8 * (value(1) - value(-1)) - (value(2) - value(-2))) / (12 * h);
  }
  return transposed(columns);
}

void expect_hessian(const Gradient& gradient,
                    TriangleHessian (*hessian)(const Vec3&, const Vec3&, const Vec3&)) {
  std::mt19937 random(12);
  for (int round = 0; round < 100; ++round) {
    const Corners p = random_corners(random);
    if (triangle_area(p[0], p[1], p[2]) < 0.1) continue;
    const TriangleHessian h = hessian(p[0], p[1], p[2]);
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        EXPECT_LT(largest(h[i][j] - difference_block(gradient, p, i, j)), 1e-7) << i << j << " " << round;
        EXPECT_LT(largest(h[i][j] - transposed(h[j][i])), 1e-15);
      }
    }
  }
}

TEST(TriangleHessianTest, AreaAgreesWithDifferences) {
  expect_hessian(triangle_area_gradient, triangle_area_hessian);
}

TEST(TriangleHessianTest, VolumeAgreesWithDifferences) {
  expect_hessian(sixfold_volume_gradient,
                 [](const Vec3& a, const Vec3& b, const Vec3& c) { return sixfold_volume_hessian(a, b, c); });
}

TEST(TriangleHessianTest, HeightIntegralAgreesWithDifferences) {
  expect_hessian(height_integral_gradient, height_integral_hessian);
}

// Moving or stretching all corners changes the gradient as homogeneity demands: not at all, and (of degree
// two, so a gradient of degree one) by itself. A turn w turns the gradient by itself.
TEST(TriangleHessianTest, AreaKnowsMotionsOfTheWhole) {
  std::mt19937 random(4);
  const Vec3 turn{0.3, -0.7, 0.2};
  for (int round = 0; round < 100; ++round) {
    const Corners p = random_corners(random);
    const TriangleHessian h = triangle_area_hessian(p[0], p[1], p[2]);
    const Corners g = triangle_area_gradient(p[0], p[1], p[2]);
    const double size = largest(h[0][0]) + largest(h[1][1]) + largest(h[2][2]);
    for (std::size_t i = 0; i < 3; ++i) {
      Mat3 moved;
      Vec3 stretched;
      Vec3 turned;
      for (std::size_t j = 0; j < 3; ++j) {
        moved += h[i][j];
        stretched += h[i][j] * p[j];
        turned += h[i][j] * cross(turn, p[j]);
      }
      EXPECT_LT(largest(moved), 1e-14 * size);
      EXPECT_LT(length(stretched - g[i]), 1e-14 * size);
      EXPECT_LT(length(turned - cross(turn, g[i])), 1e-14 * size);
    }
  }
}

// The right triangle (0,0) (a,0) (0,b) with its corner lifted by z: area sqrt(a^2 b^2 + z^2 (a^2 + b^2))/2,
// so the second derivative by z is (a^2 + b^2)/(2ab).
TEST(TriangleHessianTest, AreaOfARightTriangle) {
  const TriangleHessian h = triangle_area_hessian({0, 0, 0}, {3, 0, 0}, {0, 4, 0});
  EXPECT_NEAR(h[0][0].z.z, 25.0 / 24, 1e-15);
  EXPECT_EQ(h[0][0].x, (Vec3{}));
  EXPECT_NEAR(h[1][1].z.z, 16.0 / 24, 1e-15);
  EXPECT_NEAR(h[1][2].z.z, 0, 1e-15);
  // Area of (x1, 0), (0, y2): x1 y2 / 2.
  EXPECT_NEAR(h[1][2].x.y, 0.5, 1e-15);
}

TEST(TriangleHessianTest, NoAreaNoHessian) {
  for (const auto& row : triangle_area_hessian({0, 0, 0}, {1, 1, 1}, {2, 2, 2}))
    for (const Mat3& block : row) EXPECT_EQ(block, Mat3{});
}

TEST(EdgeHessian, AgreesWithDifferences) {
  std::mt19937 random(7);
  for (int round = 0; round < 100; ++round) {
    const Corners p = random_corners(random);
    if (length(p[1] - p[0]) < 0.3) continue;
    const Gradient gradient = [](const Vec3& tail, const Vec3& head, const Vec3&) {
      const Vec3 along = unit(head - tail);
      return Corners{-along, along, Vec3{}};
    };
    const Mat3 h = edge_length_hessian(p[0], p[1]);
    EXPECT_LT(largest(h - difference_block(gradient, p, 0, 0)), 1e-7);
    EXPECT_LT(largest(h - difference_block(gradient, p, 1, 1)), 1e-7);
    EXPECT_LT(largest(-1 * h - difference_block(gradient, p, 0, 1)), 1e-7);
  }
}

// `rim_volume_gradient` is what is missing to the sweep's share, which is (q_j x q_k)/6 short of n/6 at both
// ends.
TEST(RimHessianTest, AgreesWithDifferences) {
  const Vec3 origin{0.3, -0.2, 0.5};
  for (const OpenVolume convention : {OpenVolume::above_plane, OpenVolume::cone_from_origin}) {
    const Gradient gradient = [&](const Vec3& from, const Vec3& to, const Vec3&) {
      const RimGradient g = rim_volume_gradient(from, to, origin, convention);
      const Vec3 share = cross(from - origin, to - origin) / 6;
      return Corners{g.from + share, g.to + share, Vec3{}};
    };
    std::mt19937 random(8);
    for (int round = 0; round < 50; ++round) {
      const Corners p = random_corners(random);
      const RimHessian h = rim_volume_hessian(p[0], p[1], origin, convention);
      EXPECT_LT(largest(h.from_from - difference_block(gradient, p, 0, 0)), 1e-9);
      EXPECT_LT(largest(h.from_to - difference_block(gradient, p, 0, 1)), 1e-9);
      EXPECT_LT(largest(h.to_to - difference_block(gradient, p, 1, 1)), 1e-9);
    }
  }
}

}  // namespace
}  // namespace lamella::energy
