// What is drawn, and in which colours: filters, fields, cuts, bodies moved apart.
#include "picture/content.h"

#include <cmath>

#include <gtest/gtest.h>

#include "picture/colour_map.h"
#include "picture/drawing.h"
#include "picture/explode.h"
#include "picture/scenes.h"
#include "picture/styles.h"
#include "text/error.h"

namespace lamella::picture {
namespace {

double area(const Drawing& drawing) {
  double sum = 0;
  for (const auto& t : drawing.triangles) {
    const auto at = [&](std::size_t k) {
      const Point& p = drawing.positions[t[k]];
      return film::Vec3{p[0], p[1], p[2]};
    };
    sum += length(cross(at(1) - at(0), at(2) - at(0))) / 2;
  }
  return sum * drawing.radius * drawing.radius;
}

TEST(Content, AFilterKeepsFacetsAndTheirLines) {
  const scene::Scene scene = scenes::wire_cube(3);
  Content content;
  content.facets.assign(scene.film.triangle_rows(), 0);
  content.facets[4] = 1;
  const Drawing drawing = draw(scene, Style{}, content);
  EXPECT_EQ(drawing.triangles.size(), 1U);
  EXPECT_EQ(drawing.positions.size(), 3U);
  EXPECT_EQ(drawing.thickness.size(), 3U);
  EXPECT_LE(drawing.tubes.size(), 3U);
}

TEST(Content, AFieldOfFacetsColoursBothSides) {
  const scene::Scene scene = scenes::square_film(1);
  Content content;
  content.field = ColourField{film::ElementKind::facet, {0, 1}, 0, 1, ColourMap::viridis, "f"};
  const Drawing drawing = draw(scene, Style{}, content);
  ASSERT_EQ(drawing.tints.size(), 2U);
  EXPECT_EQ(drawing.tints[0].front.red, colour_of(ColourMap::viridis, 0).red);
  EXPECT_EQ(drawing.tints[1].behind.green, colour_of(ColourMap::viridis, 1).green);
  EXPECT_TRUE(drawing.vertex_tints.empty());
}

TEST(Content, AFieldOfVerticesLeavesHolesWhereThereIsNoNumber) {
  const scene::Scene scene = scenes::square_film(1);
  Content content;
  content.field = ColourField{film::ElementKind::vertex, {0, 1, 2, std::nan("")}, 0, 2, ColourMap::grey, "f"};
  const Drawing drawing = draw(scene, Style{}, content);
  ASSERT_EQ(drawing.vertex_tints.size(), 4U);
  float strength = 0;
  for (const VertexTint& tint : drawing.vertex_tints) strength += tint.strength;
  EXPECT_EQ(strength, 3);
  EXPECT_TRUE(drawing.tints.empty());
}

TEST(Content, APlaneCutsExactly) {
  const scene::Scene scene = scenes::square_film(7);  // from -1 to 1
  Content content;
  content.clip = ClippingPlane{{2, 0, 0}, 0.7};  // x > 0.35 goes
  const Drawing drawing = draw(scene, Style{}, content);
  EXPECT_NEAR(area(drawing), 1.35 * 2, 1e-5);
  for (const Tube& tube : drawing.tubes) {
    EXPECT_LE(std::max(tube.from[0], tube.to[0]) * drawing.radius, 0.35 + 1e-5);
  }
  content.clip = ClippingPlane{{0, 0, -1}, 5};
  EXPECT_NEAR(area(draw(scene, Style{}, content)), 4, 1e-5);
  content.clip = ClippingPlane{{0, 0, -1}, -5};
  EXPECT_TRUE(draw(scene, Style{}, content).empty());
}

TEST(Content, ThicknessGrowsDownwardsOrIsGiven) {
  const scene::Scene scene = scenes::sphere(6);
  Style style;
  style.film.thickness_top = 100;
  style.film.thickness_bottom = 500;
  const Drawing drawing = draw(scene, style);
  for (std::size_t v = 0; v < drawing.positions.size(); ++v) {
    const double depth = (1 - drawing.positions[v][2] * drawing.radius) / 2;
    EXPECT_NEAR(drawing.thickness[v], 100 + 400 * std::sqrt(std::max(0.0, depth)), 0.5);
  }
  Content content;
  content.thickness.assign(scene.film.vertex_rows(), 250);
  EXPECT_EQ(draw(scene, style, content).thickness.at(3), 250);
}

scene::Scene two_bodies() {
  scene::Scene scene = scenes::double_bubble(5, 1);
  scene.bodies.resize(2);
  return scene;
}

TEST(Explode, BodiesMoveApartWhole) {
  const scene::Scene scene = two_bodies();
  const std::vector<film::Vec3> centres = body_centres(scene);
  ASSERT_EQ(centres.size(), 3U);
  EXPECT_NEAR(centres[1].x, -centres[2].x + 1, 1e-9);  // mirrored at x = 1/2
  EXPECT_NEAR(centres[1].y, 0, 1e-9);
  Content content;
  content.explode = 0.5;
  const FilmCopy exploded = explode(scene, content);
  std::uint32_t between = 0;
  for (std::uint32_t t = 0; t < scene.film.triangle_rows(); ++t) {
    const film::RegionPair regions = scene.film.regions(film::Triangle(t));
    between += regions.front.outside() || regions.behind.outside() ? 0 : 1;
  }
  EXPECT_EQ(exploded.scene.film.triangle_count(), scene.film.triangle_count() + between);
  for (std::uint32_t e = 0; e < exploded.scene.film.edge_rows(); ++e)
    EXPECT_EQ(exploded.scene.film.valence(film::Edge(e)), 2);
  const std::vector<film::Vec3> moved = exploded_centres(scene, 0.5);
  EXPECT_NEAR(moved[2].x - moved[1].x, 1.5 * (centres[2].x - centres[1].x), 1e-12);
}

TEST(Explode, FieldsAndFiltersGoAlong) {
  scene::Scene scene = two_bodies();
  Content content;
  content.explode = 0.3;
  content.field.emplace();
  for (std::uint32_t t = 0; t < scene.film.triangle_rows(); ++t) content.field->values.push_back(t);
  content.facets.assign(scene.film.triangle_rows(), 1);
  content.facets[0] = 0;
  const FilmCopy exploded = explode(scene, content);
  EXPECT_EQ(exploded.content.field->values.size(), exploded.scene.film.triangle_rows());
  EXPECT_EQ(exploded.content.facets.size(), exploded.scene.film.triangle_rows());
  EXPECT_EQ(exploded.content.explode, 0);
  EXPECT_EQ(exploded.content.field->values[0], 0);
  EXPECT_EQ(exploded.content.facets[0], 0);
}

TEST(ColourMap, LightnessRisesEvenly) {
  double before = -1;
  for (int i = 0; i <= 20; ++i) {
    const Colour c = colour_of(ColourMap::viridis, i / 20.0);
    const double lightness = std::cbrt(0.2126 * c.red + 0.7152 * c.green + 0.0722 * c.blue);
    if (before >= 0) {
      EXPECT_GT(lightness, before + 0.01) << i;
      EXPECT_LT(lightness, before + 0.07) << i;
    }
    before = lightness;
  }
}

TEST(ColourMap, EndsAreCut) {
  EXPECT_EQ(colour_of(ColourMap::grey, -3).red, colour_of(ColourMap::grey, 0).red);
  EXPECT_EQ(colour_of(ColourMap::diverging, 9).blue, colour_of(ColourMap::diverging, 1).blue);
}

TEST(ColourMap, TicksAreRoundNumbersInTheRange) {
  EXPECT_EQ(round_ticks(0, 1, 6), (std::vector<double>{0, 0.2, 0.4, 0.6000000000000001, 0.8, 1}));
  EXPECT_EQ(round_ticks(3.2, 47, 5), (std::vector<double>{10, 20, 30, 40}));
  EXPECT_EQ(round_ticks(-1, 1, 3), (std::vector<double>{-1, 0, 1}));
  EXPECT_EQ(round_ticks(2, 2, 5), (std::vector<double>{2}));
}

TEST(Styles, EachHasANameAndAnUnknownOneIsRefused) {
  EXPECT_EQ(style_names(), (std::vector<std::string>{"film", "glass", "paper", "wire", "regions", "flat"}));
  EXPECT_TRUE(style_named("flat").film.faceted);
  try {
    style_named("glas");
    FAIL();
  } catch (const text::Error& error) {
    EXPECT_NE(error.diagnostics().at(0).hint.find("glass"), std::string::npos);
  }
}

}  // namespace
}  // namespace lamella::picture
