#include "energy/plateau.h"

#include <gtest/gtest.h>

#include "support/shapes.h"

namespace lamella::energy {
namespace {

using test::Builder;

// The cone over the edges of a regular tetrahedron: six films, four borders, one quad point, all angles
// exact.
film::Film tetrahedral_cone() {
  Builder b;
  const film::Vertex centre = b.vertex({0, 0, 0});
  std::vector<film::Vertex> v;
  for (const film::Vec3& p :
       {film::Vec3{1, 1, 1}, film::Vec3{1, -1, -1}, film::Vec3{-1, 1, -1}, film::Vec3{-1, -1, 1}}) {
    v.push_back(b.vertex(p));
  }
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = i + 1; j < 4; ++j) b.triangle(centre, v[i], v[j]);
  }
  b.film.sort_all_sides();
  return b.film;
}

TEST(Plateau, TetrahedralConeIsExact) {
  const PlateauAngles angles = plateau_angles(tetrahedral_cone());
  EXPECT_EQ(angles.triple.angles, 12U);
  EXPECT_EQ(angles.quad.angles, 6U);
  EXPECT_LT(angles.triple.worst, 1e-12);
  EXPECT_LT(angles.quad.worst, 1e-12);
  EXPECT_EQ(angles.other_points, 0U);
}

TEST(Plateau, DeviationsAreInDegrees) {
  Builder b;
  const film::Vertex p = b.vertex({0, 0, 0});
  const film::Vertex q = b.vertex({0, 0, 2});
  for (const double degrees : {0.0, 90.0, 180.0}) {
    const double a = degrees * M_PI / 180;
    b.triangle(p, q, b.vertex({std::cos(a), std::sin(a), 0.7}));
  }
  b.film.sort_all_sides();
  const PlateauAngles angles = plateau_angles(b.film);  // 90, 90 and 180 degrees
  EXPECT_NEAR(angles.triple.worst, 60, 1e-10);
  EXPECT_NEAR(angles.triple.rms, std::sqrt((900 + 900 + 3600) / 3.0), 1e-10);
}

TEST(Plateau, MoreThanThreeFilmsAreNamed) {
  Builder b;
  const film::Vertex p = b.vertex({0, 0, 0});
  const film::Vertex q = b.vertex({0, 0, 2});
  for (int i = 0; i < 4; ++i) b.triangle(p, q, b.vertex({std::cos(1.5 * i), std::sin(1.5 * i), 0.7}));
  b.film.sort_all_sides();
  EXPECT_EQ(plateau_angles(b.film).other_borders, 1U);
  EXPECT_EQ(plateau_angles(b.film).triple.angles, 0U);
}

}  // namespace
}  // namespace lamella::energy
