// The bound on explicit steps beside the largest frequency of the film.
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "evolution/motion.h"
#include "support/shapes.h"
#include "surgery/refine.h"

namespace lamella::evolution {
namespace {

using scene::Scene;

// The largest eigenvalue of the films' stiffness (cotangents) relative to a third of the areas around each
// vertex, from below: by power iteration. The Hessian of the area lies below that matrix.
double largest_square(const film::Film& film) {
  const std::span<const Vec3> x = film.positions();
  const auto& triangles = film.connectivity().triangle_vertices;
  std::vector<double> mass(x.size());
  for (const auto& [a, b, c] : triangles) {
    const double area = 0.5 * length(cross(x[b.index] - x[a.index], x[c.index] - x[a.index]));
    for (const film::Vertex v : {a, b, c}) mass[v.index] += area / 3;
  }
  std::vector<double> y(x.size());
  std::mt19937_64 numbers(1);
  std::normal_distribution<double> any;
  for (double& value : y) value = any(numbers);
  double quotient = 0;
  for (int i = 0; i < 600; ++i) {
    std::vector<double> image(y.size());
    for (const auto& corners : triangles) {
      std::array<Vec3, 3> side;
      for (std::size_t k = 0; k < 3; ++k)
        side[k] = x[corners[(k + 2) % 3].index] - x[corners[(k + 1) % 3].index];
      const double doubled = length(cross(side[0], side[1]));
      for (std::size_t k = 0; k < 3; ++k) {
        for (std::size_t l = 0; l < 3; ++l)
          image[corners[k].index] += dot(side[k], side[l]) / (2 * doubled) * y[corners[l].index];
      }
    }
    double energy = 0;
    double square = 0;
    for (std::size_t v = 0; v < y.size(); ++v) {
      energy += y[v] * image[v];
      square += mass[v] * y[v] * y[v];
      image[v] /= mass[v];
    }
    quotient = energy / square;
    double scale = 0;
    for (const double value : image) scale = std::max(scale, std::abs(value));
    for (std::size_t v = 0; v < y.size(); ++v) y[v] = image[v] / scale;
  }
  return quotient;
}

Scene shaken(int level, double part, unsigned seed) {
  Scene scene = test::cube();
  for (int i = 0; i < level; ++i) surgery::refine(scene.film);
  std::mt19937_64 numbers(seed);
  std::normal_distribution<double> any(0, part * std::ldexp(0.7, -level));
  for (Vec3& p : scene.film.edit_positions()) {
    for (int axis = 0; axis < 3; ++axis) p[axis] += any(numbers);
  }
  return scene;
}

// Never above what linear theory allows, and not far below: at meshes as they should be, and at drawn-out
// ones.
TEST(Bound, IsBelowTheLargestStableStepAndNearIt) {
  for (const double part : {0.02, 0.1, 0.25, 0.5}) {
    for (unsigned seed = 1; seed <= 6; ++seed) {
      Scene scene = shaken(2, part, seed);
      const double ratio = 0.5 * Motion(scene).bound() * std::sqrt(largest_square(scene.film));
      EXPECT_LT(ratio, 1) << part << " " << seed;
      EXPECT_GT(ratio, 0.75) << part << " " << seed;
    }
  }
}

// A bound that follows from the film alone: whatever was before, and whichever way the spots were found.
TEST(Bound, IsThatOfAMotionBegunAnew) {
  Scene scene = shaken(3, 0.15, 1);
  Motion motion(scene);
  for (int i = 0; i < 30; ++i) {
    ASSERT_EQ(motion.step(0.3 * motion.bound()), solve::Ending::step_limit);
    motion.leave();
    Scene copy = scene;
    ASSERT_EQ(Motion(copy).bound(), motion.bound()) << i;
  }
}

}  // namespace
}  // namespace lamella::evolution
