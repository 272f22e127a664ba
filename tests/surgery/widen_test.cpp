#include "surgery/widen.h"

#include <cmath>

#include <gtest/gtest.h>

#include "energy/mesh_quality.h"
#include "film/check.h"
#include "support/shapes.h"

namespace lamella::surgery {
namespace {

constexpr double degree = M_PI / 180;

TEST(Widen, OpensWhatAveragingDrewTogether) {
  scene::Scene scene = test::square_film(6);
  film::Film& film = scene.film;
  const auto fixed = film.columns(film::ElementKind::vertex).flags("fixed");
  const std::vector<film::Vec3> before(film.positions().begin(), film.positions().end());
  // One vertex nearly on its neighbour.
  std::uint32_t moved = 0;
  while (fixed[moved] != 0) ++moved;
  film.for_each_end(film::Vertex(moved), [&](film::EdgeEnd end) {
    film.edit_positions()[moved] = before[moved] + 0.85 * film.vector(end.outward());
  });
  ASSERT_LT(energy::smallest_angle(film), 10 * degree);
  EXPECT_GT(widen_angles(film, 27 * degree), 0U);
  EXPECT_GT(energy::smallest_angle(film), 27 * degree);
  EXPECT_TRUE(film::check(film).empty());
  for (std::uint32_t v = 0; v < before.size(); ++v) {
    if (fixed[v] != 0) {
      EXPECT_EQ(film.positions()[v], before[v]);
    }
    EXPECT_NEAR(film.positions()[v].z, before[v].z, 1e-12);  // within the film
  }
}

TEST(Widen, LeavesAFitMeshAlone) {
  scene::Scene scene = test::square_film(6);
  EXPECT_EQ(widen_angles(scene.film, 27 * degree), 0U);
}

}  // namespace
}  // namespace lamella::surgery
