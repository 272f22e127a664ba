#include "energy/film_energy.h"

#include <gtest/gtest.h>

#include "energy/measure.h"
#include "energy/triangle.h"
#include "support/differences.h"
#include "support/shapes.h"

namespace lamella::energy {
namespace {

using film::ElementKind;
using scene::Scene;

std::vector<Vec3> positions_of(const Scene& scene) {
  return {scene.film.positions().begin(), scene.film.positions().end()};
}

// A foam with everything an energy can have: tensions of facets and edges, heavy bodies, a prescribed
// pressure.
Scene rich_foam(unsigned seed) {
  Scene scene = test::random_foam(seed);
  std::mt19937 random(seed + 100);
  std::uniform_real_distribution<double> u(0.5, 2);
  film::Column& tension = scene.film.columns(ElementKind::facet).add(film::real_column("tension", 1));
  for (std::uint32_t t = 0; t < scene.film.triangle_rows(); ++t) tension.set(t, 0, u(random));
  film::Column& line = scene.film.columns(ElementKind::edge).add(film::real_column("tension", 0));
  for (std::uint32_t e = 0; e < scene.film.edge_rows(); e += 3) line.set(e, 0, u(random));
  scene.bodies[0].density = 1.3;
  scene.bodies[2].density = -0.4;
  scene.bodies[1].target_volume.reset();
  scene.bodies[1].fixed_pressure = 0.7;
  scene.bodies[3].volume_offset = 0.25;
  scene.gravity.constant = 1.7;
  return scene;
}

void expect_gradient_by_differences(const Scene& scene) {
  FilmEnergy energy(scene);
  const std::vector<Vec3> x = positions_of(scene);
  const double at_x = energy.gradient(x);
  EXPECT_NEAR(at_x, energy.value(x), 1e-12 * std::abs(at_x));
  std::vector<Vec3> g;
  energy.gradient(x);
  for (const VertexLine& line : energy.lines()) g.push_back(line.gradient);
  const auto d =
      test::gradient_by_differences(x, [&](const std::vector<Vec3>& y) { return energy.value(y); });
  for (std::size_t v = 0; v < x.size(); ++v) EXPECT_LT(length(g[v] - d[v]), 2e-7) << "vertex " << v;
}

TEST(FilmEnergy, GradientAgreesWithDifferences) {
  for (unsigned seed = 0; seed < 3; ++seed) expect_gradient_by_differences(rich_foam(seed));
  expect_gradient_by_differences(test::cube());
  Scene cap = test::open_cap();
  cap.bodies[0].target_volume.reset();
  cap.bodies[0].fixed_pressure = 2;
  cap.bodies[0].density = 0.8;
  expect_gradient_by_differences(cap);
  cap.symmetric_content = true;
  expect_gradient_by_differences(cap);
}

void expect_volume_gradients_by_differences(const Scene& scene) {
  FilmEnergy energy(scene);
  const std::vector<Vec3> x = positions_of(scene);
  energy.gradient(x);
  const std::size_t rows = energy.constrained().size();
  std::vector<std::vector<Vec3>> g(rows, std::vector<Vec3>(x.size()));
  energy.volume_gradient().for_each([&](std::uint32_t v, int row, const Vec3& gradient) {
    g[static_cast<std::size_t>(row)][v] += gradient;
  });
  FilmEnergy other(scene);
  for (std::size_t row = 0; row < rows; ++row) {
    const std::uint32_t region = energy.constrained()[row].index;
    const auto d = test::gradient_by_differences(x, [&](const std::vector<Vec3>& y) {
      other.value(y);
      return other.volumes()[region];
    });
    for (std::size_t v = 0; v < x.size(); ++v) {
      EXPECT_LT(length(g[row][v] - d[v]), 1e-10) << "vertex " << v << ", region " << region;
    }
  }
}

TEST(FilmEnergy, VolumeGradientsAgreeWithDifferences) {
  for (unsigned seed = 0; seed < 3; ++seed) expect_volume_gradients_by_differences(test::random_foam(seed));
  expect_volume_gradients_by_differences(test::open_cap());
  Scene symmetric = test::open_cap();
  symmetric.symmetric_content = true;
  expect_volume_gradients_by_differences(symmetric);
}

// The products that solvers need, against the plain gradients.
TEST(FilmEnergy, GramDotAndPullAgreeWithTheRows) {
  const Scene scene = test::random_foam(4);
  FilmEnergy energy(scene);
  const std::vector<Vec3> x = positions_of(scene);
  energy.gradient(x);
  VolumeGradient& gradient = energy.volume_gradient();
  const std::size_t rows = energy.constrained().size();
  std::vector<std::vector<Vec3>> g(rows, std::vector<Vec3>(x.size()));
  gradient.for_each(
      [&](std::uint32_t v, int row, const Vec3& value) { g[static_cast<std::size_t>(row)][v] += value; });
  std::vector<double> weights(x.size());
  for (std::size_t v = 0; v < x.size(); ++v) weights[v] = 0.5 + 0.01 * static_cast<double>(v % 17);

  std::vector<double> values(gradient.pattern().size());
  gradient.gram(weights, values);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const GramEntry entry = gradient.pattern()[i];
    double sum = 0;
    for (std::size_t v = 0; v < x.size(); ++v) {
      sum += weights[v] *
             dot(g[static_cast<std::size_t>(entry.row)][v], g[static_cast<std::size_t>(entry.column)][v]);
    }
    EXPECT_NEAR(values[i], sum, 1e-13);
  }
  std::vector<double> products(rows);
  gradient.dot(weights, x, products);
  std::vector<double> factors;
  for (std::size_t r = 0; r < rows; ++r) {
    double sum = 0;
    for (std::size_t v = 0; v < x.size(); ++v) sum += weights[v] * dot(g[r][v], x[v]);
    EXPECT_NEAR(products[r], sum, 1e-12);
    factors.push_back(1.0 + static_cast<double>(r));
  }
  gradient.set_multipliers(factors);
  for (std::size_t v = 0; v < x.size(); ++v) {
    Vec3 sum;
    for (std::size_t r = 0; r < rows; ++r) sum += factors[r] * g[r][v];
    EXPECT_LT(length(gradient.pull(v) - sum), 1e-13);
  }
}

TEST(FilmEnergy, CubeIsExact) {
  Scene scene = test::cube(2);
  EXPECT_DOUBLE_EQ(measure(scene).area, 24);
  EXPECT_DOUBLE_EQ(measure(scene).volumes[1], 8);
  scene.bodies[0].density = 3;  // the centre of mass at z = 1
  EXPECT_DOUBLE_EQ(measure(scene).energy, 24 + 3 * 8 * 1);
}

// A volume must not depend on where the body stands, nor on how it is turned.
TEST(FilmEnergy, VolumeDoesNotDependOnPlace) {
  Scene scene = test::random_foam(6);
  const Measures here = measure(scene);
  test::rotate_all(scene.film, {1, 2, 3}, 0.7);
  const Measures turned = measure(scene);
  test::move_all(scene.film, {1000, -2000, 3000});
  const Measures far = measure(scene);
  EXPECT_NEAR(turned.area, here.area, 1e-12 * here.area);
  EXPECT_NEAR(far.area, here.area, 1e-11 * here.area);
  for (std::size_t r = 1; r < here.volumes.size(); ++r) {
    EXPECT_NEAR(turned.volumes[r], here.volumes[r], 1e-12);
    EXPECT_NEAR(far.volumes[r], here.volumes[r], 1e-9);
  }
}

TEST(FilmEnergy, FarAwayTheVolumeKeepsItsDigits) {
  Scene scene = test::cube(1, {1048576, -1048576, 524288});  // the corners are exact numbers
  EXPECT_DOUBLE_EQ(measure(scene).volumes[1], 1);
}

// The cells' volumes are those of their triangles summed by hand, whatever the number of triangles left over
// for the last batch.
TEST(FilmEnergy, SweepAgreesWithAPlainSum) {
  for (unsigned seed = 0; seed < 8; ++seed) {
    const Scene scene = rich_foam(seed);
    const auto tension = scene.film.columns(ElementKind::facet).reals("tension");
    double area = 0;
    double energy = 0;
    std::vector<double> volumes(scene.bodies.size() + 1, 0.0);
    for (std::uint32_t t = 0; t < scene.film.triangle_rows(); ++t) {
      const auto& c = scene.film.corners(film::Triangle(t));
      const Vec3& p = scene.film.position(c[0]);
      const Vec3& q = scene.film.position(c[1]);
      const Vec3& r = scene.film.position(c[2]);
      area += triangle_area(p, q, r);
      energy += tension[t] * triangle_area(p, q, r);
      volumes[scene.film.regions(film::Triangle(t)).behind.index] += sixfold_volume(p, q, r) / 6;
      volumes[scene.film.regions(film::Triangle(t)).front.index] -= sixfold_volume(p, q, r) / 6;
    }
    Scene plain = scene;
    plain.film.columns(ElementKind::edge).remove("tension");
    plain.gravity.on = false;
    plain.bodies[1].fixed_pressure.reset();
    const Measures m = measure(plain);
    EXPECT_NEAR(m.area, area, 1e-12 * area);
    EXPECT_NEAR(m.energy, energy, 1e-12 * energy);
    for (std::size_t r = 1; r < volumes.size(); ++r) {
      EXPECT_NEAR(m.volumes[r], volumes[r] + scene.bodies[r - 1].volume_offset, 1e-12);
    }
  }
}

// z dx dy over a cap, against the same cap closed by a fan down to the plane z = 0.
TEST(OpenRim, VolumeIsThatAboveThePlane) {
  Scene cap = test::open_cap(0.5, 7);
  const double open = measure(cap).volumes[1];
  double closed = 0;
  for (std::uint32_t t = 0; t < cap.film.triangle_rows(); ++t) {
    const auto& c = cap.film.corners(film::Triangle(t));
    const Vec3& p = cap.film.position(c[0]);
    const Vec3& q = cap.film.position(c[1]);
    const Vec3& r = cap.film.position(c[2]);
    closed += 0.5 * double_area_vector(p, q, r).z * (p.z + q.z + r.z) / 3;
  }
  EXPECT_NEAR(open, closed, 1e-13);
  cap.symmetric_content = true;
  double cones = 0;
  for (std::uint32_t t = 0; t < cap.film.triangle_rows(); ++t) {
    const auto& c = cap.film.corners(film::Triangle(t));
    cones += sixfold_volume(cap.film.position(c[0]), cap.film.position(c[1]), cap.film.position(c[2])) / 6;
  }
  EXPECT_NEAR(measure(cap).volumes[1], cones, 1e-13);
  EXPECT_EQ(open_rims(cap.film).size(), 7U);
  EXPECT_TRUE(open_rims(test::cube().film).empty());
  EXPECT_TRUE(open_rims(test::random_foam(2).film).empty());
}

TEST(Measure, CacheFollowsEveryChange) {
  Scene scene = test::cube();
  MeasureCache cache;
  EXPECT_DOUBLE_EQ(cache.of(scene).energy, 6);
  scene.film.columns(ElementKind::facet).add(film::real_column("tension", 2));
  EXPECT_DOUBLE_EQ(cache.of(scene).energy, 12);
  scene.bodies[0].density = 1;
  EXPECT_DOUBLE_EQ(cache.of(scene).energy, 12.5);
  scene.gravity.on = false;
  EXPECT_DOUBLE_EQ(cache.of(scene).energy, 12);
  scene.bodies[0].fixed_pressure = 3;
  EXPECT_DOUBLE_EQ(cache.of(scene).energy, 9);
  scene.bodies[0].volume_offset = 1;
  EXPECT_DOUBLE_EQ(cache.of(scene).volumes[1], 2);
  const Scene before = scene;
  for (Vec3& p : scene.film.edit_positions()) p *= 2;
  EXPECT_DOUBLE_EQ(cache.of(scene).area, 24);
  EXPECT_DOUBLE_EQ(cache.of(before).area, 6);
}

}  // namespace
}  // namespace lamella::energy
