// Other programs open what is exported and report the same figures. Skipped where they are missing.
#include <array>
#include <cstdio>
#include <map>
#include <sstream>

#include <gtest/gtest.h>

#include "exchange/export.h"
#include "exchange/measured.h"
#include "picture/scenes.h"
#include "support/folder.h"

namespace lamella::exchange {
namespace {

using trial::Folder;
namespace scenes = picture::scenes;

std::string output_of(const std::string& command) {
  std::string output;
  std::FILE* const pipe = popen((command + " 2>/dev/null").c_str(), "r");
  if (pipe == nullptr) return output;
  std::array<char, 4096> block{};
  while (const std::size_t count = std::fread(block.data(), 1, block.size(), pipe))
    output.append(block.data(), count);
  pclose(pipe);
  return output;
}

scene::Scene foam() {
  scene::Scene scene = scenes::double_bubble(6, 0.7);
  scene.bodies.resize(2);
  return scene;
}

std::string exported(const Folder& folder, const scene::Scene& scene, const std::string& name,
                     const ExportOptions& options = {}) {
  const Exported result = export_scene(scene, folder / name, options);
  write_files(result.files);
  return result.files.front().path;
}

// --- VTK, by Python

constexpr const char* vtk_script = R"py(
import sys, vtk
reader = vtk.vtkXMLPolyDataReader() if sys.argv[1].endswith('vtp') else vtk.vtkXMLUnstructuredGridReader()
reader.SetFileName(sys.argv[1])
size = vtk.vtkCellSizeFilter()
size.SetInputConnection(reader.GetOutputPort())
size.ComputeSumOn()
size.Update()
surface = vtk.vtkGeometryFilter()
surface.SetInputConnection(reader.GetOutputPort())
edges = vtk.vtkFeatureEdges()
edges.SetInputConnection(surface.GetOutputPort())
for off in (edges.BoundaryEdgesOff, edges.FeatureEdgesOff, edges.ManifoldEdgesOff): off()
edges.NonManifoldEdgesOn()
edges.Update()
data = reader.GetOutput()
cells = data.GetCellData()
kind, behind = cells.GetArray('kind'), cells.GetArray('behind')
rows = range(data.GetNumberOfCells())
sums = size.GetOutput().GetFieldData()
print('points', data.GetNumberOfPoints())
print('triangles', sum(kind.GetValue(i) == 0 for i in rows))
print('borders', sum(kind.GetValue(i) == 1 for i in rows))
print('body2', sum(behind.GetValue(i) == 2 for i in rows))
print('area', repr(sums.GetArray('Area').GetValue(0)))
print('length', repr(sums.GetArray('Length').GetValue(0)))
print('nonmanifold', edges.GetOutput().GetNumberOfCells())
print('ids', data.GetPointData().GetArray('id').GetValue(0))
)py";

std::map<std::string, double> vtk_figures(const Folder& folder, const std::string& path) {
  const std::string script = folder.write("figures.py", vtk_script);
  std::istringstream output(output_of("/usr/bin/python3 '" + script + "' '" + path + "'"));
  std::map<std::string, double> figures;
  std::string name;
  double value = 0;
  while (output >> name >> value) figures[name] = value;
  return figures;
}

TEST(OtherReaders, Vtk) {
  if (output_of("/usr/bin/python3 -c 'import vtk; print(1)'") != "1\n")
    GTEST_SKIP() << "VTK for Python (python3-vtk9) is not installed";
  const Folder folder;
  const scene::Scene scene = foam();
  const Measured m = measured(scene);
  for (const char* name : {"a.vtp", "a.vtu"}) {
    SCOPED_TRACE(name);
    std::map<std::string, double> figures = vtk_figures(folder, exported(folder, scene, name));
    EXPECT_EQ(figures["points"], m.vertices);
    EXPECT_EQ(figures["triangles"], m.facets);
    EXPECT_EQ(figures["borders"], 1);
    EXPECT_EQ(figures["nonmanifold"], m.borders);
    EXPECT_NEAR(figures["area"], m.area, 1e-9);
    EXPECT_GT(figures["length"], 3);
    EXPECT_GT(figures["body2"], 0);
    EXPECT_EQ(figures["ids"], 1);
  }
}

// --- Blender

constexpr const char* blender_script = R"py(import bpy, bmesh, sys
path = sys.argv[sys.argv.index('--') + 1]
bpy.ops.object.select_all(action='SELECT')
bpy.ops.object.delete()
if path.endswith('.obj'):
    bpy.ops.wm.obj_import(filepath=path)
elif path.endswith('.ply'):
    bpy.ops.import_mesh.ply(filepath=path)
else:
    bpy.ops.import_mesh.stl(filepath=path)
vertices = faces = borders = 0
area = 0.0
for thing in bpy.data.objects:
    if thing.type != 'MESH': continue
    mesh = bmesh.new()
    mesh.from_mesh(thing.data)
    vertices += len(mesh.verts)
    faces += len(mesh.faces)
    area += sum(f.calc_area() for f in mesh.faces)
    borders += sum(len(e.link_faces) > 2 for e in mesh.edges)
print('figure vertices', vertices)
print('figure faces', faces)
print('figure area', area)
print('figure borders', borders)
)py";

TEST(OtherReaders, Blender) {
  if (output_of("blender --version").empty()) GTEST_SKIP() << "Blender is not installed";
  const Folder folder;
  const scene::Scene scene = foam();
  const Measured m = measured(scene);
  const std::string script = folder.write("figures.py", blender_script);
  for (const char* name : {"a.ply", "a.obj", "a.stl"}) {
    SCOPED_TRACE(name);
    std::istringstream output(output_of("blender --background --factory-startup --python '" + script +
                                        "' -- '" + exported(folder, scene, name) + "' | grep '^figure'"));
    std::map<std::string, double> figures;
    std::string word;
    double value = 0;
    while (output >> word >> word >> value) figures[word] = value;
    EXPECT_EQ(figures["vertices"], m.vertices);
    EXPECT_EQ(figures["faces"], m.facets);
    EXPECT_EQ(figures["borders"], m.borders);
    EXPECT_NEAR(figures["area"], m.area, 1e-6 * m.area);
  }
}

// --- assimp

// The number after `name:` in what `assimp info` says.
long assimp_count(const std::string& info, const std::string& name) {
  const std::size_t at = info.find(name + ":");
  return at == std::string::npos ? -1 : std::stol(info.substr(at + name.size() + 1));
}

TEST(OtherReaders, Assimp) {
  if (output_of("assimp version").empty()) GTEST_SKIP() << "assimp (assimp-utils) is not installed";
  const Folder folder;
  const scene::Scene scene = foam();
  const Measured m = measured(scene);
  const auto info = [&](const std::string& name) {
    return output_of("assimp info '" + exported(folder, scene, name) + "' --raw");
  };
  const std::string ply = info("a.ply");
  EXPECT_EQ(assimp_count(ply, "Faces"), m.facets);
  EXPECT_EQ(assimp_count(ply, "Vertices"), m.vertices);
  EXPECT_EQ(assimp_count(info("a.stl"), "Faces"), m.facets);
  const std::string obj = info("a.obj");
  EXPECT_EQ(assimp_count(obj, "Meshes"), 4);  // three films and the border
  EXPECT_EQ(assimp_count(obj, "Faces"), m.facets + m.borders);
  const std::string glb = info("a.glb");
  EXPECT_EQ(assimp_count(glb, "Meshes"), 4);
  EXPECT_EQ(assimp_count(glb, "Cameras"), 1);
  EXPECT_GT(assimp_count(glb, "Faces"), m.facets);
  const std::string body =
      output_of("assimp info '" + exported(folder, scene, "b.obj", {Division::body, {}}) + "' ");
  EXPECT_EQ(assimp_count(body, "Vertices") - assimp_count(body, "Faces") / 2, 2);  // Euler's, of a sphere
}

}  // namespace
}  // namespace lamella::exchange
