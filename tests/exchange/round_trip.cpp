// What is exported comes back by import: the same complex, the same regions.
#include <algorithm>
#include <random>

#include <gtest/gtest.h>

#include "exchange/export.h"
#include "exchange/import.h"
#include "exchange/measured.h"
#include "exchange/parts.h"
#include "exchange/stl.h"
#include "film/check.h"
#include "picture/scenes.h"
#include "support/folder.h"
#include "text/error.h"
#include "text/whole_file.h"

namespace lamella::exchange {
namespace {

using picture::scenes::Builder;
using trial::Folder;
namespace scenes = picture::scenes;

scene::Scene with_bodies(scene::Scene scene, std::size_t count) {
  scene.bodies.resize(count);
  return scene;
}

void expect_same(const scene::Scene& before, const Imported& imported, double tolerance) {
  const Measured a = measured(before);
  const Measured b = measured(imported.scene);
  EXPECT_EQ(b.vertices, a.vertices);
  EXPECT_EQ(b.edges, a.edges);
  EXPECT_EQ(b.facets, a.facets);
  EXPECT_EQ(b.borders, a.borders);
  EXPECT_EQ(b.rims, a.rims);
  EXPECT_NEAR(b.area, a.area, tolerance * a.area);
  std::vector<double> volumes_before(a.volumes.begin() + 1, a.volumes.end());
  std::vector<double> volumes(b.volumes.begin() + 1, b.volumes.end());
  std::sort(volumes_before.begin(), volumes_before.end());
  std::sort(volumes.begin(), volumes.end());
  ASSERT_EQ(volumes.size(), volumes_before.size());
  for (std::size_t i = 0; i < volumes.size(); ++i) EXPECT_NEAR(volumes[i], volumes_before[i], tolerance);
  EXPECT_TRUE(film::check(imported.scene.film).empty());
  EXPECT_TRUE(imported.warnings.empty());
}

Imported there_and_back(const scene::Scene& scene, const std::string& ending) {
  const Folder folder;
  const std::string path = folder / ("scene" + ending);
  write_files(export_scene(scene, path, {}).files);
  return import_scene(path, {});
}

// n * n * n cubes, whose regions are found.
scene::Scene foam(int n) {
  return there_and_back(scenes::lattice(n, 2), ".stl").scene;
}

TEST(RoundTrip, FindsTheCellsOfAFoam) {
  const Measured m = measured(foam(3));
  ASSERT_EQ(m.volumes.size(), 28U);
  for (std::size_t b = 1; b <= 27; ++b) EXPECT_NEAR(m.volumes[b] / m.volumes[1], 1, 1e-5);
  EXPECT_NEAR(-m.volumes[0] / m.volumes[1], 27, 1e-4);
  EXPECT_EQ(measured(there_and_back(scenes::kelvin(1, 1), ".stl").scene).volumes.size(), 2U);
}

TEST(RoundTrip, KeepsTheComplexAndItsRegions) {
  const scene::Scene scenes[] = {with_bodies(scenes::sphere(4), 1),
                                 with_bodies(scenes::double_bubble(6, 0.7), 2), foam(2), scenes::wire_cube(3),
                                 scenes::twisted_band(6, 2)};
  for (const scene::Scene& scene : scenes) {
    for (const char* ending : {".obj", ".ply"}) {
      SCOPED_TRACE(ending);
      const Imported imported = there_and_back(scene, ending);
      EXPECT_FALSE(imported.found_regions);
      expect_same(scene, imported, 1e-12);
    }
  }
}

// STL tells neither points shared nor regions: both are found, to its single precision.
TEST(RoundTrip, FindsRegionsInLooseTriangles) {
  for (const scene::Scene& scene :
       {with_bodies(scenes::double_bubble(6, 0.7), 2), foam(3), scenes::wire_cube(3)}) {
    const Imported imported = there_and_back(scene, ".stl");
    EXPECT_TRUE(imported.found_regions);
    expect_same(scene, imported, 2e-6);
  }
}

TEST(RoundTrip, WiresAndRimsAreFixed) {
  const Imported imported = there_and_back(scenes::wire_cube(3), ".stl");
  EXPECT_EQ(imported.fixed_edges, measured(imported.scene).rims);
  EXPECT_EQ(imported.fixed_edges, 36U);
  const Folder folder;
  write_files(export_scene(scenes::wire_cube(3), folder / "a.stl", {}).files);
  EXPECT_EQ(import_scene(folder / "a.stl", {.tolerance = {}, .labels = {}, .free_rims = true}).fixed_edges,
            0U);
}

// Each body by itself is closed; together they make the foam again.
TEST(RoundTrip, BodiesAreClosedAndShareTheirWalls) {
  const scene::Scene scene = foam(2);
  const Folder folder;
  const Exported exported = export_scene(scene, folder / "cell.stl", {Division::body, {}});
  EXPECT_TRUE(exported.warnings.empty());
  ASSERT_EQ(exported.files.size(), 8U);
  EXPECT_EQ(exported.files[2].path, folder / "cell-3.stl");
  std::string all = std::string(80, ' ') + std::string(4, '\0');
  std::uint32_t count = 0;
  for (const NamedFile& file : exported.files) {
    write_files({file});
    const Measured one = measured(import_scene(file.path, {}).scene);
    EXPECT_EQ(one.rims, 0U);
    EXPECT_NEAR(one.volumes.at(1), measured(scene).volumes.at(1), 1e-6);
    count += one.facets;
    all += file.content.substr(84);
  }
  std::copy_n(reinterpret_cast<const char*>(&count), 4, all.begin() + 80);
  text::write_whole_file(folder / "all.stl", all);
  const Imported together = import_scene(folder / "all.stl", {});
  EXPECT_GT(together.duplicates, 0U);
  expect_same(scene, together, 2e-6);
}

TEST(RoundTrip, ABodyThatIsNotClosedIsTold) {
  scene::Scene scene = with_bodies(scenes::sphere(3), 1);
  scene.film.remove(film::Triangle(0U));
  const Exported exported = export_scene(scene, "cap.obj", {Division::body, {}});
  ASSERT_EQ(exported.warnings.size(), 1U);
  EXPECT_NE(exported.warnings[0].find("body 1 is not closed"), std::string::npos);
}

// Facets turned at random are turned back.
TEST(Import, MendsOrientation) {
  scene::Scene scene = with_bodies(scenes::double_bubble(6, 0.7), 2);
  Mesh mesh = mesh_of(scene);
  std::mt19937 random(3);
  for (Triple& t : mesh.triangles) {
    if (random() % 2 == 0) std::swap(t[0], t[1]);
  }
  const Folder folder;
  text::write_whole_file(folder / "a.stl", write_stl(mesh));
  const Imported imported = import_scene(folder / "a.stl", {});
  expect_same(scene, imported, 2e-6);
  for (std::uint32_t t = 0; t < imported.scene.film.triangle_rows(); ++t) {
    const film::RegionPair pair = imported.scene.film.regions(film::Triangle(t));
    EXPECT_LT(pair.front.index, pair.behind.index);
  }
  ASSERT_EQ(imported.scene.bodies.size(), 2U);
  EXPECT_NEAR(*imported.scene.bodies[0].target_volume, measured(imported.scene).volumes[1], 1e-12);
}

// A ball of this radius as loose triangles.
void add_ball(std::vector<film::Vec3>& corners, const film::Vec3& middle, double radius) {
  const scene::Scene ball = scenes::sphere(4);
  for (std::uint32_t t = 0; t < ball.film.triangle_rows(); ++t) {
    for (const film::Vec3& p : ball.film.points(film::Triangle(t))) corners.push_back(middle + radius * p);
  }
}

std::string obj_of(const std::vector<film::Vec3>& corners) {
  std::string text;
  for (const film::Vec3& p : corners) text += fmt::format("v {} {} {}\n", p.x, p.y, p.z);
  for (std::size_t i = 1; i <= corners.size(); i += 3) text += fmt::format("f {} {} {}\n", i, i + 1, i + 2);
  return text;
}

TEST(Import, CellsWithinCells) {
  std::vector<film::Vec3> corners;
  add_ball(corners, {0, 0, 0}, 1);
  add_ball(corners, {0.1, 0, 0}, 0.6);                                     // in the first
  add_ball(corners, {0.2, 0.1, 0}, 0.3);                                   // in the second
  add_ball(corners, {-0.72, 0, 0}, 0.15);                                  // in the first, beside the second
  add_ball(corners, {3, 0, 0}, 1);                                         // apart
  corners.insert(corners.end(), {{2.9, 0, 0}, {3.1, 0, 0}, {3, 0.2, 0}});  // an open film in the last
  const Folder folder;
  text::write_whole_file(folder / "a.obj", obj_of(corners));
  const Imported imported = import_scene(folder / "a.obj", {});
  const Measured m = measured(imported.scene);
  ASSERT_EQ(m.volumes.size(), 6U);
  const double unit = measured(scenes::sphere(4)).volumes.at(1);
  EXPECT_NEAR(m.volumes[1], unit * (1 - 0.216 - 0.003375), 1e-9);
  EXPECT_NEAR(m.volumes[2], unit * (0.216 - 0.027), 1e-9);
  EXPECT_NEAR(m.volumes[3], unit * 0.027, 1e-9);
  EXPECT_NEAR(m.volumes[4], unit * 0.003375, 1e-9);
  EXPECT_NEAR(m.volumes[5], unit, 1e-9);
  const film::RegionPair open =
      imported.scene.film.regions(film::Triangle(imported.scene.film.triangle_rows() - 1));
  EXPECT_EQ(open, (film::RegionPair{film::Region{5}, film::Region{5}}));
  EXPECT_TRUE(film::check_regions(imported.scene.film).empty());
}

TEST(Import, PointsWithinTheToleranceAreOne) {
  std::vector<film::Vec3> corners;
  add_ball(corners, {0, 0, 0}, 1);
  const auto shared = static_cast<std::size_t>(scenes::sphere(4).film.vertex_count());
  std::mt19937 random(5);
  std::uniform_real_distribution<double> jitter(-1e-5, 1e-5);
  for (film::Vec3& p : corners) p += {jitter(random), jitter(random), jitter(random)};
  const Folder folder;
  text::write_whole_file(folder / "a.obj", obj_of(corners));
  EXPECT_EQ(import_scene(folder / "a.obj", {}).scene.bodies.size(), 0U);
  const Imported welded =
      import_scene(folder / "a.obj", {.tolerance = 1e-4, .labels = {}, .free_rims = false});
  EXPECT_EQ(welded.scene.film.vertex_count(), shared);
  EXPECT_EQ(welded.merged_points, corners.size() - shared);
  EXPECT_EQ(welded.scene.bodies.size(), 1U);
}

TEST(Import, PolygonsAreCutWhereTheyAreNotConvexToo) {
  const Folder folder;
  // An L of area 3 and a square of area 4, which repeats a corner.
  text::write_whole_file(folder / "a.off",
                         "OFF\n10 2 0 # an L and a square\n0 0 0\n2 0 0\n2 1 0\n1 1 0\n1 2 0\n0 2 0\n"
                         "5 0 0\n7 0 0\n7 2 0\n5 2 0\n6 0 1 2 3 4 5\n5 6 7 8 9 9 255 0 0\n");
  const Measured m = measured(import_scene(folder / "a.off", {}).scene);
  EXPECT_EQ(m.facets, 6U);
  EXPECT_EQ(m.vertices, 10U);
  EXPECT_NEAR(m.area, 7, 1e-12);
}

// Two cubes that share a wall, each with its squares; the wall's corners are listed from another one on.
TEST(Import, SharedPolygonsAreCutAlike) {
  const Folder folder;
  text::write_whole_file(folder / "a.obj",
                         "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
                         "v 2 0 0\nv 2 1 0\nv 2 0 1\nv 2 1 1\n"
                         "f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 3 4 8 7\nf 4 1 5 8\nf 2 3 7 6\n"
                         "f 2 3 10 9\nf 6 11 12 7\nf 2 9 11 6\nf 10 3 7 12\nf 9 10 12 11\nf 3 2 6 7\n");
  const Imported imported = import_scene(folder / "a.obj", {});
  const Measured m = measured(imported.scene);
  EXPECT_EQ(imported.duplicates, 2U);
  EXPECT_EQ(m.facets, 22U);
  ASSERT_EQ(m.volumes.size(), 3U);
  EXPECT_NEAR(m.volumes[1], 1, 1e-12);
  EXPECT_NEAR(m.volumes[2], 1, 1e-12);
}

TEST(Import, LabelsTellRegions) {
  const Folder folder;
  text::write_whole_file(folder / "a.obj",
                         "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n");
  text::write_whole_file(folder / "labels", "# front behind\n0 2\n0 2\n\n2 0\n0 2\n");
  const Imported imported =
      import_scene(folder / "a.obj", {.tolerance = {}, .labels = folder / "labels", .free_rims = false});
  EXPECT_FALSE(imported.found_regions);
  ASSERT_EQ(imported.scene.bodies.size(), 2U);
  EXPECT_TRUE(imported.scene.bodies[0].absent);
  EXPECT_FALSE(imported.scene.bodies[1].absent);
  // The third facet is labelled the wrong way round: the label is believed, the facet turned.
  EXPECT_EQ(imported.scene.film.regions(film::Triangle(2U)),
            (film::RegionPair{film::Region{0}, film::Region{2}}));
  EXPECT_FALSE(imported.warnings.empty() && measured(imported.scene).volumes[2] > 1.0 / 6 - 1e-9);
}

}  // namespace
}  // namespace lamella::exchange
