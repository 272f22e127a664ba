// What the files of each format say.
#include <cstring>

#include <gtest/gtest.h>

#include "exchange/export.h"
#include "exchange/measured.h"
#include "exchange/parts.h"
#include "exchange/vtk.h"
#include "picture/scenes.h"

namespace lamella::exchange {
namespace {

namespace scenes = picture::scenes;

std::string content(const scene::Scene& scene, const std::string& path) {
  const Exported exported = export_scene(scene, path, {});
  return exported.files.back().content;
}

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

long count(const std::string& text, const std::string& part) {
  long n = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

TEST(Formats, ObjHasAGroupForEachPairOfRegions) {
  const std::string text = content(scenes::double_bubble(4, 0.7), "a.obj");
  for (const char* group : {"g film_0_1\n", "g film_0_2\n", "g film_1_2\n", "g border\n"})
    EXPECT_EQ(count(text, group), 1) << group;
  EXPECT_EQ(count(text, "\nl "), 1);  // the border is one line
}

TEST(Formats, LinesRunFromCornerToCorner) {
  const Mesh cube = mesh_of(scenes::wire_cube(3));
  long borders = 0;
  long wires = 0;
  std::size_t wire_edges = 0;
  for (const Line& line : cube.lines) {
    (line.kind == picture::LineKind::border ? borders : wires) += 1;
    if (line.kind == picture::LineKind::wire) wire_edges += line.points.size() - 1;
  }
  EXPECT_EQ(borders, 12);  // 8 from the corners, 4 around the square in the middle
  EXPECT_EQ(wires, 12);
  EXPECT_EQ(wire_edges, 36U);
  const Mesh ring = mesh_of(scenes::double_bubble(4, 1));
  ASSERT_EQ(ring.lines.size(), 1U);
  EXPECT_EQ(ring.lines[0].points.front(), ring.lines[0].points.back());
}

TEST(Formats, FilmsEndAtBorders) {
  const Mesh cube = mesh_of(scenes::wire_cube(3));
  const std::vector<Part> films = films_of(cube);
  EXPECT_EQ(films.size(), 13U);
  std::size_t triangles = 0;
  for (const Part& film : films) triangles += film.triangles.size();
  EXPECT_EQ(triangles, cube.triangles.size());
}

TEST(Formats, NormalsOfASphereAreItsRadii) {
  const Mesh ball = mesh_of(scenes::sphere(8));
  const std::vector<Part> bodies = bodies_of(ball);
  ASSERT_EQ(bodies.size(), 1U);
  EXPECT_TRUE(bodies[0].closed);
  const std::vector<film::Vec3> normals = normals_of(ball, bodies[0]);
  for (std::size_t i = 0; i < normals.size(); ++i)
    EXPECT_GT(dot(normals[i], unit(ball.points[bodies[0].points[i]])), 0.98);
}

TEST(Formats, ColumnsBecomeAttributes) {
  scene::Scene scene = scenes::sphere(2);
  film::Column velocity = film::real_column("velocity", 0, 3);
  velocity.resize(scene.film.vertex_rows());
  scene.film.columns(film::ElementKind::vertex).add(std::move(velocity));
  scene.film.columns(film::ElementKind::facet).add(film::integer_column("color", 4));
  const std::string vtp = content(scene, "a.vtp");
  EXPECT_TRUE(has(vtp, "Name=\"velocity\" NumberOfComponents=\"3\""));
  EXPECT_TRUE(has(vtp, "Name=\"color\""));
  const std::string ply = content(scene, "a.ply");
  EXPECT_TRUE(has(ply, "property double velocity_3\n"));
  EXPECT_TRUE(has(ply, "property uchar red\n"));
}

TEST(Formats, SeriesInTime) {
  const std::string text = write_pvd({{0, "a-0000.vtp"}, {0.25, "a-0001.vtp"}});
  EXPECT_TRUE(has(text, "<DataSet timestep=\"0.25\" part=\"0\" file=\"a-0001.vtp\"/>"));
}

// The header's lengths are those of the file, or no reader would take it.
TEST(Formats, GlbIsAsLongAsItSays) {
  const std::string glb = content(scenes::double_bubble(4, 0.7), "a.glb");
  std::uint32_t numbers[5];
  std::memcpy(numbers, glb.data(), sizeof numbers);
  EXPECT_EQ(glb.substr(0, 4), "glTF");
  EXPECT_EQ(numbers[1], 2U);
  EXPECT_EQ(numbers[2], glb.size());
  EXPECT_EQ(numbers[3] % 4, 0U);
  EXPECT_TRUE(has(glb, "\"KHR_materials_iridescence\":{\"iridescenceFactor\":1,\"iridescenceIor\":1.33"));
  EXPECT_EQ(count(glb, "\"name\":\"film "), 6);  // three meshes and their nodes
}

TEST(Formats, MitsubaNamesItsMeshes) {
  const Exported exported = export_scene(scenes::wire_cube(3), "some/where/cube.xml", {});
  ASSERT_EQ(exported.files.size(), 4U);
  EXPECT_EQ(exported.files[0].path, "some/where/cube-films.ply");
  EXPECT_EQ(exported.files[1].path, "some/where/cube-borders.ply");
  EXPECT_EQ(exported.files[2].path, "some/where/cube-wires.ply");
  const std::string& xml = exported.files[3].content;
  for (const char* part : {"value=\"cube-films.ply\"", "thindielectric", "<lookat origin=", "value=\"1200\""})
    EXPECT_TRUE(has(xml, part)) << part;
}

}  // namespace
}  // namespace lamella::exchange
