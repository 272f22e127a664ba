#include "evolution/levels.h"

#include <cmath>

#include <gtest/gtest.h>

#include "evolution/adapt.h"
#include "evolution/bulge.h"
#include "support/shapes.h"
#include "surgery/refine.h"

namespace lamella::evolution {
namespace {

using film::Vec3;
using scene::Scene;

constexpr double sphere = 4.835975862049;  // area around volume 1

Scene bubble(int level) {
  Scene scene = test::cube();
  for (int i = 0; i < level; ++i) surgery::refine(scene.film);
  scene::Monitor monitor;
  relax(scene, {}, monitor);
  return scene;
}

TEST(Bulge, MiddlesLieOnTheSphere) {
  const Scene scene = bubble(3);
  const std::vector<Vec3> bulge = bulges(scene.film);
  // Facets cut off volume, for which vertices lie farther out than the sphere.
  double radius = 0;
  for (const Vec3& p : scene.film.positions())
    radius += length(p - Vec3{0.5, 0.5, 0.5}) / scene.film.vertex_rows();
  double straight = 0;
  double bulged = 0;
  for (std::uint32_t i = 0; i < scene.film.edge_rows(); ++i) {
    const auto [tail, head] = scene.film.ends(film::Edge(i));
    const Vec3 middle = 0.5 * (scene.film.position(tail) + scene.film.position(head));
    straight += radius - length(middle - Vec3{0.5, 0.5, 0.5});
    bulged += std::abs(radius - length(middle + bulge[i] - Vec3{0.5, 0.5, 0.5}));
  }
  EXPECT_LT(bulged, 0.25 * straight);
}

TEST(Bulge, FlatFilmsAndFixedEdgesStay) {
  const Scene scene = test::square_film(5);
  for (const Vec3& bulge : bulges(scene.film)) EXPECT_LT(length(bulge), 1e-15);
}

TEST(EnergyError, IsTheSpheresError) {
  for (int level = 2; level <= 4; ++level) {
    const Scene scene = bubble(level);
    scene::Monitor monitor;
    Scene copy = scene;
    const double error = relax(copy, {}, monitor).energy - sphere;
    EXPECT_NEAR(sum_errors(facet_errors(scene)).whole / error, 1, 0.05) << level;
  }
}

// Errors that fall as one over the facets are summed to the end.
TEST(Extrapolate, FindsTheLimitOfAGeometricRow) {
  const std::vector<Level> levels{{100, 5 + 0.1}, {400, 5 + 0.025}, {1600, 5 + 0.00625}};
  const auto found = extrapolate(levels);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->energy, 5, 1e-12);
  EXPECT_NEAR(found->estimate, 0.00625 / 5, 1e-12);
  EXPECT_FALSE(extrapolate({{100, 5.1}, {400, 5.025}}));
}

}  // namespace
}  // namespace lamella::evolution
