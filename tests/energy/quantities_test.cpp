// Methods of named quantities, held against finite differences.
#include <random>

#include <gtest/gtest.h>

#include "energy/film_energy.h"
#include "energy/measure.h"
#include "energy/quantity_sums.h"
#include "support/differences.h"
#include "support/formulas.h"
#include "support/shapes.h"

namespace lamella::energy {
namespace {

using scene::Method;
using scene::MethodInstance;

constexpr const char* integrand = "x^2*y - sin(z) + 0.3*exp(x*z)";

// An octahedron out of shape, with a quantity of one method taken of everything.
scene::Scene scene_with(Method method) {
  scene::Scene scene;
  scene.film = test::cube().film;
  scene.bodies.resize(1);
  scene.bodies[0].density = 1.3;
  film::Column fixed = film::flag_column("fixed");
  fixed.resize(scene.film.vertex_rows());
  for (const std::uint32_t v : {0U, 1U, 3U}) fixed.set(v, 0, 1);
  scene.film.columns(film::ElementKind::vertex).add(std::move(fixed));
  test::jitter(scene.film, 7, 0.15);
  MethodInstance instance;
  instance.method = method;
  instance.global = true;
  instance.modulus = 1.7;
  instance.scalar = test::formula(integrand);
  instance.field = {test::formula("x*y - z^3"), test::formula("cos(x)*z"), test::formula("x^2 + y*z")};
  if (method == Method::facet_general_integral)
    instance.scalar =
        test::formula("sqrt(x4^2 + 2*x5^2 + x6^2)*(2 + x*y) + z*x4", language::FormulaKind::space_and_normal);
  scene::Quantity quantity;
  quantity.name = "test";
  quantity.role = scene::QuantityRole::energy;
  quantity.modulus = 0.6;
  quantity.methods.push_back(instance);
  scene.quantities.push_back(quantity);
  return scene;
}

std::vector<Vec3> positions_of(const scene::Scene& scene) {
  return {scene.film.positions().begin(), scene.film.positions().end()};
}

class Methods : public testing::TestWithParam<Method> {};

TEST_P(Methods, GradientsAgreeWithDifferences) {
  const scene::Scene scene = scene_with(GetParam());
  const std::vector<Vec3> x = positions_of(scene);
  const QuantitySum sum(scene, scene.quantities[0], x, {});
  std::vector<Vec3> gradient(x.size());
  const double value = sum.add_gradient(x, 0, 1, gradient);
  EXPECT_NEAR(value, sum.value(x, 0), 1e-13 * (1 + std::abs(value)));
  EXPECT_NE(value, 0);
  const auto wanted =
      test::gradient_by_differences(x, [&](const std::vector<Vec3>& y) { return sum.value(y, 0); });
  for (std::size_t v = 0; v < x.size(); ++v) EXPECT_LT(length(gradient[v] - wanted[v]), 1e-8) << v;
}

class Blocks : public HessianSink {
 public:
  explicit Blocks(std::size_t vertices) : blocks_(vertices, std::vector<Mat3>(vertices)) {}
  void add(std::uint32_t u, std::uint32_t v, const Mat3& block) override {
    blocks_[u][v] += block;
    if (u != v) blocks_[v][u] += transposed(block);
  }
  const Mat3& at(std::size_t u, std::size_t v) const { return blocks_[u][v]; }

 private:
  std::vector<std::vector<Mat3>> blocks_;
};

TEST_P(Methods, HessiansAgreeWithDifferences) {
  const scene::Scene scene = scene_with(GetParam());
  std::vector<Vec3> x = positions_of(scene);
  const QuantitySum sum(scene, scene.quantities[0], x, {});
  Blocks blocks(x.size());
  sum.add_hessian(x, 0, 1, blocks);
  for (std::size_t v = 0; v < x.size(); ++v) {
    for (int axis = 0; axis < 3; ++axis) {
      const double at = x[v][axis];
      const auto gradient = [&](double step) {
        std::vector<Vec3> g(x.size());
        x[v][axis] = at + step * 1e-3;
        sum.add_gradient(x, 0, 1, g);
        x[v][axis] = at;
        return g;
      };
      const auto p1 = gradient(1);
      const auto m1 = gradient(-1);
      const auto p2 = gradient(2);
      const auto m2 = gradient(-2);
      for (std::size_t u = 0; u < x.size(); ++u) {
        const Vec3 wanted = (8 * (p1[u] - m1[u]) - (p2[u] - m2[u])) / 12e-3;
        Vec3 direction;
        direction[axis] = 1;
        EXPECT_LT(length(blocks.at(u, v) * direction - wanted), 1e-7) << u << " " << v;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, Methods,
                         testing::Values(Method::vertex_scalar_integral, Method::edge_length,
                                         Method::edge_scalar_integral, Method::edge_vector_integral,
                                         Method::facet_area, Method::density_facet_area, Method::facet_volume,
                                         Method::facet_scalar_integral, Method::facet_vector_integral,
                                         Method::facet_general_integral, Method::gravity_method,
                                         Method::mean_curvature_integral, Method::star_gauss_curvature,
                                         Method::gauss_curvature_integral, Method::sq_mean_curvature,
                                         Method::star_perp_sq_mean_curvature),
                         [](const auto& parameter) { return std::string(scene::name_of(parameter.param)); });

// Twelve edges of a cube turn by a right angle; eight corners lack a quarter of a circle each.
TEST(QuantitiesOfAngles, OfACube) {
  scene::Scene scene = scene_with(Method::mean_curvature_integral);
  scene.film = test::cube().film;
  scene.quantities[0].modulus = scene.quantities[0].methods[0].modulus = 1;
  const double side = std::sqrt(measure(scene).area / 6);
  EXPECT_NEAR(quantity_value(scene, 0), 12 * side * M_PI / 4, 1e-13);
  scene.quantities[0].methods[0].method = Method::star_gauss_curvature;
  EXPECT_NEAR(quantity_value(scene, 0), 4 * M_PI, 1e-12);
}

// What the film's energy makes of a quantity.
TEST(QuantitiesInEnergy, CountInValueAndGradient) {
  for (const Method method : {Method::facet_vector_integral, Method::sq_mean_curvature}) {
    const scene::Scene scene = scene_with(method);
    const std::vector<Vec3> x = positions_of(scene);
    FilmEnergy energy(scene);
    scene::Scene without = scene;
    without.quantities.clear();
    EXPECT_NEAR(measure(scene).energy, measure(without).energy + quantity_value(scene, 0), 1e-13);
    EXPECT_NEAR(energy.value(x), measure(scene).energy, 1e-12);
    energy.gradient(x);
    const auto wanted =
        test::gradient_by_differences(x, [&](const std::vector<Vec3>& y) { return energy.value(y); });
    energy.gradient(x);
    for (std::size_t v = 0; v < x.size(); ++v)
      EXPECT_LT(length(energy.lines()[v].gradient - wanted[v]), 1e-8);
  }
}

film::Film sphere(int rows) {
  test::Builder b;
  std::vector<std::vector<film::Vertex>> ring(static_cast<std::size_t>(rows) + 1);
  const int around = 2 * rows;
  for (int i = 0; i <= rows; ++i) {
    const double polar = M_PI * i / rows;
    const int count = i == 0 || i == rows ? 1 : around;
    for (int k = 0; k < count; ++k) {
      const double turn = 2 * M_PI * k / around;
      ring[std::size_t(i)].push_back(
          b.vertex({std::sin(polar) * std::cos(turn), std::sin(polar) * std::sin(turn), std::cos(polar)}));
    }
  }
  const auto at = [&](int i, int k) {
    const auto& row = ring[std::size_t(i)];
    return row[std::size_t(k) % row.size()];
  };
  for (int i = 0; i < rows; ++i) {
    for (int k = 0; k < around; ++k) {
      if (i + 1 < rows) b.triangle(at(i, k), at(i + 1, k), at(i + 1, k + 1));
      if (i > 0) b.triangle(at(i, k), at(i + 1, k + 1), at(i, k + 1));
    }
  }
  return std::move(b.film);
}

// On a sphere of radius r the mean curvature is 1/r: its square integrates to 4 pi.
TEST(QuantitiesInEnergy, CurvatureOfASphere) {
  scene::Scene scene = scene_with(Method::sq_mean_curvature);
  scene.film = sphere(40);
  scene.quantities[0].modulus = scene.quantities[0].methods[0].modulus = 1;
  EXPECT_NEAR(quantity_value(scene, 0), 4 * M_PI, 0.1);
  scene.quantities[0].methods[0].method = Method::star_perp_sq_mean_curvature;
  EXPECT_NEAR(quantity_value(scene, 0), 4 * M_PI, 0.1);
}

}  // namespace
}  // namespace lamella::energy
