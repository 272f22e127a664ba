// Files with a fault: what is told of it, and where.
#include <cstring>

#include <gtest/gtest.h>

#include "exchange/export.h"
#include "exchange/import.h"
#include "picture/scenes.h"
#include "support/folder.h"
#include "text/error.h"
#include "text/whole_file.h"

namespace lamella::exchange {
namespace {

using trial::Folder;

std::string complaint(const std::string& name, const std::string& content, const std::string& labels = {}) {
  const Folder folder;
  text::write_whole_file(folder / name, content);
  ImportOptions options;
  if (!labels.empty()) {
    text::write_whole_file(folder / "labels", labels);
    options.labels = folder / "labels";
  }
  try {
    import_scene(folder / name, options);
  } catch (const text::Error& error) {
    return error.what();
  }
  return "nothing wrong";
}

::testing::AssertionResult says(const std::string& message, std::initializer_list<std::string> parts) {
  for (const std::string& part : parts) {
    if (message.find(part) == std::string::npos)
      return ::testing::AssertionFailure() << "\"" << part << "\" is not in:\n" << message;
  }
  return ::testing::AssertionSuccess();
}

const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

TEST(Mistakes, Obj) {
  EXPECT_TRUE(says(complaint("a.obj", triangle + "f 1 2 4\n"), {"a.obj:4:7", "no vertex 4", "has 3"}));
  EXPECT_TRUE(says(complaint("a.obj", triangle + "f 1 2 0\n"), {"a.obj:4:7", "count from 1"}));
  EXPECT_TRUE(says(complaint("a.obj", triangle + "f 1 2 -4\n"), {"a.obj:4:7", "no vertex -4"}));
  EXPECT_TRUE(says(complaint("a.obj", triangle + "f 1 2\n"), {"a.obj:4:6", "three corners"}));
  EXPECT_TRUE(says(complaint("a.obj", "v 0 zero 0\n"), {"a.obj:1:5", "not \"zero\""}));
  EXPECT_TRUE(says(complaint("a.obj", "v 0 0\n"), {"a.obj:1:6", "ends before a coordinate"}));
  EXPECT_TRUE(says(complaint("a.obj", "v 0 0 nan\n"), {"a.obj:1:7"}));
  EXPECT_TRUE(says(complaint("a.obj", "vertex 0 0 0\n"), {"a.obj:1:1", "no statement"}));
  EXPECT_TRUE(says(complaint("a.obj", triangle), {"no facet"}));
  EXPECT_TRUE(says(complaint("a.obj", ""), {"no facet"}));
}

TEST(Mistakes, Off) {
  EXPECT_TRUE(
      says(complaint("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n"), {"a.off:5:1", "vertex 2 of 3 is missing"}));
  EXPECT_TRUE(says(complaint("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n"),
                   {"a.off:6:7", "no vertex 3", "0 to 2"}));
  EXPECT_TRUE(says(complaint("a.off", "OFF\n-3 1 0\n"), {"a.off:2:1", "cannot be -3"}));
  EXPECT_TRUE(says(complaint("a.off", "OFF\n"), {"before its counts"}));
}

TEST(Mistakes, Stl) {
  EXPECT_TRUE(says(complaint("a.stl", "solid\nfacet normal 0 0 1\nvertex 0 0 0\nvertex 1 0\n"),
                   {"a.stl:4:11", "ends before"}));
  EXPECT_TRUE(says(complaint("a.stl", "solid\nvertex 0 0 0\nendfacet\n"), {"a.stl:3:1", "1 corners"}));
  EXPECT_TRUE(says(complaint("a.stl", "not at all"), {"no STL file"}));
  EXPECT_TRUE(says(complaint("a.stl", "solid\nfacte\n"), {"a.stl:2:1", "facte"}));
}

std::string ply(const std::string& format, const std::string& data) {
  return "ply\nformat " + format +
         " 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
         "element face 1\nproperty list uchar int vertex_indices\nend_header\n" +
         data;
}

TEST(Mistakes, Ply) {
  const std::string points = "0 0 0\n1 0 0\n0 1 0\n";
  EXPECT_TRUE(says(complaint("a.ply", ply("ascii", points + "3 0 1 3\n")), {"a.ply:13:1", "names vertex 3"}));
  EXPECT_TRUE(says(complaint("a.ply", ply("ascii", points + "3 0 1\n")), {"a.ply:13:6", "line ends"}));
  EXPECT_TRUE(says(complaint("a.ply", ply("ascii", points)), {"face 0 of 1 is missing"}));
  EXPECT_TRUE(says(complaint("a.ply", ply("binary_little_endian", "abc")), {"ends within vertex 1 of 3"}));
  EXPECT_TRUE(says(complaint("a.ply", ply("middle_endian", "")), {"a.ply:2:8", "the format is"}));
  EXPECT_TRUE(says(complaint("a.ply", "ply\nelement vertex many\n"), {"a.ply:2:16", "whole number"}));
  EXPECT_TRUE(says(complaint("a.ply", "plyx\n"), {"a.ply:1:1"}));
  EXPECT_TRUE(says(complaint("a.ply", "ply\n"), {"end_header"}));
}

TEST(Mistakes, BigEndianIsRead) {
  std::string data;
  const auto put = [&](auto value) {
    char block[sizeof value];
    std::memcpy(block, &value, sizeof value);
    std::string bytes(block, sizeof value);
    data.append(bytes.rbegin(), bytes.rend());
  };
  for (const float x : {0.F, 0.F, 0.F, 1.F, 0.F, 0.F, 0.F, 1.F, 0.F}) put(x);
  put(std::uint8_t{3});
  for (const std::int32_t v : {0, 1, 2}) put(v);
  EXPECT_EQ(complaint("a.ply", ply("binary_big_endian", data)), "nothing wrong");
}

TEST(Mistakes, Labels) {
  const std::string mesh = triangle + "f 1 2 3\n";
  EXPECT_TRUE(says(complaint("a.obj", mesh, "0\n"), {"labels:1:2", "region behind"}));
  EXPECT_TRUE(says(complaint("a.obj", mesh, "0 1\n1 0\n"), {"labels:2:1", "only 1 facets"}));
  EXPECT_TRUE(says(complaint("a.obj", mesh, "# none\n"), {"0 facets are labelled, and there are 1"}));
  EXPECT_TRUE(says(complaint("a.obj", mesh, "0 -1\n"), {"labels:1:3", "cannot be -1"}));
  EXPECT_TRUE(says(complaint("a.obj", mesh, "0 1 2\n"), {"labels:1:5"}));
}

TEST(Mistakes, KindsOfFiles) {
  EXPECT_TRUE(says(complaint("a.fe", ""), {"\".fe\"", "load FILE.fe"}));
  EXPECT_TRUE(says(complaint("mesh", ""), {"there is none"}));
  const Folder folder;
  EXPECT_THROW(import_scene(folder / "none.obj", {}), text::Error);
  EXPECT_THROW(format_of("a.vtk"), text::Error);
  EXPECT_THROW(format_of("a"), text::Error);
  EXPECT_EQ(format_of("A.PLY"), Format::ply);
}

TEST(Mistakes, ExportsLeaveNothingHalfDone) {
  const Folder folder;
  const scene::Scene scene = picture::scenes::double_bubble(3, 1);
  EXPECT_THROW(export_scene(scene::Scene{}, "a.vtp", {}), text::Error);
  EXPECT_THROW(export_scene(scene, "a.vtp", {Division::body, {}}), text::Error);
  EXPECT_THROW(export_scene(picture::scenes::square_film(2), "a.stl", {Division::body, {}}), text::Error);
  text::write_whole_file(folder / "old", "as it was");
  EXPECT_THROW(write_files({{folder / "new", "1"}, {folder / "no/such/folder", "2"}}), text::Error);
  EXPECT_FALSE(std::filesystem::exists(folder / "new"));
  EXPECT_THROW(write_files({{folder / "old", "1"}, {folder / "no/such/folder", "2"}}), text::Error);
  EXPECT_TRUE(std::filesystem::exists(folder / "old"));
}

}  // namespace
}  // namespace lamella::exchange
