#include "picture/drawing.h"

#include <cmath>
#include <limits>
#include <map>

#include <gtest/gtest.h>

#include "picture/lines.h"
#include "picture/scenes.h"
#include "picture/sheets.h"
#include "text/error.h"

namespace lamella::picture {
namespace {

using film::ElementKind;
using film::Vec3;

Vec3 vec3(const Point& p) {
  return {p[0], p[1], p[2]};
}

std::map<film::Vertex, int> shaded_vertices_at(const Sheets& sheets) {
  std::map<film::Vertex, int> count;
  for (const auto& shaded : sheets.vertices) ++count[shaded.vertex];
  return count;
}

TEST(Sheets, NormalsOfASphereAreRadial) {
  const scene::Scene scene = scenes::sphere(8);
  const Sheets sheets = find_sheets(scene.film, 50);
  EXPECT_EQ(sheets.vertices.size(), scene.film.vertex_count());
  EXPECT_TRUE(sheets.creases.empty());
  for (const auto& shaded : sheets.vertices) {
    EXPECT_GT(dot(vec3(shaded.normal), scene.film.position(shaded.vertex)), 0.99999);
  }
}

TEST(Sheets, EachFilmHasItsOwnNormalAtABorder) {
  const scene::Scene scene = scenes::double_bubble(6, 1);
  const Sheets sheets = find_sheets(scene.film, 50);
  std::map<film::Vertex, bool> on_border;
  for (std::uint32_t e = 0; e < scene.film.edge_rows(); ++e) {
    if (scene.film.valence(film::Edge(e)) != 3) continue;
    for (const film::Vertex v : scene.film.ends(film::Edge(e))) on_border[v] = true;
  }
  EXPECT_EQ(on_border.size(), 24U);
  for (const auto& [v, count] : shaded_vertices_at(sheets)) EXPECT_EQ(count, on_border.contains(v) ? 3 : 1);
}

TEST(Sheets, CubeIsCreasedAlongItsEdges) {
  const scene::Scene scene = scenes::lattice(1, 2);
  const Sheets sheets = find_sheets(scene.film, 50);
  EXPECT_EQ(sheets.creases.size(), 24U);
  int corners = 0;
  for (const auto& [v, count] : shaded_vertices_at(sheets)) {
    const Vec3 p = scene.film.position(v);
    int integers = 0;
    for (int k = 0; k < 3; ++k) integers += p[k] == std::floor(p[k]) ? 1 : 0;
    EXPECT_EQ(count, integers);
    corners += integers == 3 ? 1 : 0;
  }
  EXPECT_EQ(corners, 8);
}

// On a one-sided band no winding is consistent, yet every facet gets normals on its own front.
TEST(Sheets, MoebiusBandIsSmooth) {
  const scene::Scene scene = scenes::twisted_band(4, 1);
  const film::Film& film = scene.film;
  const Sheets sheets = find_sheets(film, 50);
  EXPECT_TRUE(sheets.creases.empty());
  for (std::uint32_t t = 0; t < film.triangle_rows(); ++t) {
    const auto& c = film.corners(film::Triangle(t));
    const Vec3 a = film.position(c[0]);
    const Vec3 facet = unit(cross(film.position(c[1]) - a, film.position(c[2]) - a));
    for (std::uint32_t k = 0; k < 3; ++k) {
      EXPECT_GT(dot(facet, vec3(sheets.vertices[sheets.of_corner[3 * t + k]].normal)), 0.9);
    }
  }
}

TEST(Lines, EveryKindOfEdge) {
  scenes::Builder b;
  const auto v = [&](double x, double y, double z) { return b.vertex({x, y, z}); };
  const auto o = v(0, 0, 0);
  const auto p = v(1, 0, 0);
  b.triangle(o, p, v(0, 1, 0));
  b.triangle(p, o, v(0, -1, 1));
  b.triangle(p, o, v(0, -1, -1));
  const film::Edge border = b.edge(o, p);
  const film::Edge rim = b.edge(p, v(0, 1, 0));
  const film::Edge frame = b.edge(o, v(0, 1, 0));
  const film::Edge wire = b.edge(p, v(2, 0, 0));
  b.fix(frame);
  const scene::Scene scene = b.finish();
  EXPECT_EQ(line_kind(scene.film, border), LineKind::border);
  EXPECT_EQ(line_kind(scene.film, rim), LineKind::rim);
  EXPECT_EQ(line_kind(scene.film, frame), LineKind::wire);
  EXPECT_EQ(line_kind(scene.film, wire), LineKind::wire);
}

TEST(Lines, FixedEdgesInsideAFixedPatchAreNoLines) {
  scenes::Builder b;
  b.patch({0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, 1);
  const film::Edge diagonal = b.edge(b.vertex({0, 0, 0}), b.vertex({1, 1, 0}));
  b.fix(diagonal);
  scene::Scene scene = b.finish();
  EXPECT_EQ(line_kind(scene.film, diagonal), LineKind::wire);
  film::Column fixed = film::flag_column("fixed");
  fixed.blank = 1;
  scene.film.columns(ElementKind::facet).add(std::move(fixed));
  EXPECT_EQ(line_kind(scene.film, diagonal), LineKind::none);
}

TEST(Lines, QuadPointsAreBalls) {
  const scene::Scene scene = scenes::wire_cube(2);
  const Drawing drawing = draw(scene, Style{});
  int balls = 0;
  for (const Tube& tube : drawing.tubes) balls += tube.from == tube.to ? 1 : 0;
  EXPECT_EQ(balls, 4);  // the corners of the square in the middle
}

TEST(Drawing, FacetsThatAreClearOrNotDisplayedAreLeftOut) {
  scene::Scene scene = scenes::square_film(2);
  film::Columns& columns = scene.film.columns(ElementKind::facet);
  columns.add(film::integer_column("color", 15)).set(0, 0, -1);
  columns.edit("color")->set(1, 0, 4);
  columns.add(film::flag_column("nodisplay")).set(5, 0, 1);
  const Drawing drawing = draw(scene, Style{});
  EXPECT_EQ(drawing.triangles.size(), 6U);
  ASSERT_EQ(drawing.tints.size(), 6U);
  EXPECT_EQ(drawing.tints[0].front_strength, 1);  // red, in front and behind
  EXPECT_EQ(drawing.tints[0].behind_strength, 1);
  EXPECT_GT(drawing.tints[0].front.red, 4 * drawing.tints[0].front.blue);
  EXPECT_EQ(drawing.tints[1].front_strength, 0);  // white means plain
}

TEST(Drawing, ATombstoneIsNotDrawn) {
  scene::Scene scene = scenes::square_film(2);
  scene.film.remove(film::Triangle(3U));
  const Drawing drawing = draw(scene, Style{});
  EXPECT_EQ(drawing.triangles.size(), 7U);
}

TEST(Drawing, UnitsAreThoseOfTheScene) {
  scene::Scene scene = scenes::sphere(6);
  const Drawing here = draw(scene, Style{});
  for (Vec3& p : scene.film.edit_positions()) p = 1e-5 * p + Vec3{4, -5, 6};
  const Drawing there = draw(scene, Style{});
  ASSERT_EQ(here.positions.size(), there.positions.size());
  for (std::size_t v = 0; v < here.positions.size(); ++v) {
    EXPECT_LT(length(vec3(here.positions[v]) - vec3(there.positions[v])), 1e-6);
    EXPECT_LE(length(vec3(here.positions[v])), 1 + 1e-6);
  }
}

TEST(Drawing, RefusesCoordinatesThatAreNotFinite) {
  scene::Scene scene = scenes::square_film(2);
  scene.film.move(film::Vertex(4U), {0, std::numeric_limits<double>::quiet_NaN(), 0});
  try {
    draw(scene, Style{});
    FAIL() << "drawn";
  } catch (const text::Error& error) {
    EXPECT_NE(std::string(error.what()).find("vertex 5"), std::string::npos) << error.what();
  }
}

TEST(Drawing, RefusesAnImmenseScene) {
  scene::Scene scene = scenes::square_film(2);
  scene.film.move(film::Vertex(4U), {1e200, 0, 0});
  EXPECT_THROW(draw(scene, Style{}), text::Error);
  for (Vec3& p : scene.film.edit_positions()) p = 1e100 * unit(p);
  EXPECT_FALSE(draw(scene, Style{}).empty());
}

}  // namespace
}  // namespace lamella::picture
