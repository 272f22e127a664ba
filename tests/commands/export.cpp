#include "support/trial.h"

namespace lamella::trial {
namespace {

TEST(Export, WritesWhatTheEndingSays) {
  Trial trial("double_bubble.fe");
  const Folder folder;
  const auto write = [&](const std::string& name, const std::string& words = {}) {
    trial.out("export \"" + (folder / name) + "\" " + words);
    return file_content(folder / name);
  };
  EXPECT_TRUE(contains(write("a.vtp"), "<VTKFile type=\"PolyData\""));
  EXPECT_TRUE(contains(write("a.vtu"), "<VTKFile type=\"UnstructuredGrid\""));
  EXPECT_TRUE(contains(write("a.ply"), "element face"));
  EXPECT_TRUE(contains(write("a.obj"), "g film_1_2"));
  EXPECT_EQ(write("a.stl").size() % 50, 84U % 50);
  EXPECT_TRUE(contains(write("a.glb", "view top drain (100, 300)"), "\"iridescenceThicknessMaximum\":300"));
  EXPECT_TRUE(contains(write("a.xml", "size=64x48"), "value=\"48\""));
  EXPECT_TRUE(contains(write("a.fe"), "bodies"));
}

TEST(Export, BodiesAndValues) {
  Trial trial("double_bubble.fe");
  const Folder folder;
  trial.out("export \"" + (folder / "b.stl") + "\" per=body");
  EXPECT_NE(file_content(folder / "b-1.stl"), "");
  EXPECT_NE(file_content(folder / "b-2.stl"), "");
  EXPECT_FALSE(std::filesystem::exists(folder / "b.stl"));
  trial.out("export \"" + (folder / "v.ply") + "\" values=vertex z^2");
  EXPECT_TRUE(contains(file_content(folder / "v.ply"), "property double values"));
}

TEST(Export, Refuses) {
  Trial trial;
  EXPECT_TRUE(contains(trial.failure("export a.ply"), "nothing to export"));
  trial.session().load(datafile("cube.fe"));
  EXPECT_TRUE(contains(trial.failure("export a.plz"), "did you mean \".ply\"?"));
  EXPECT_TRUE(contains(trial.failure("export"), "needs file"));
  EXPECT_TRUE(contains(trial.failure("export a.vtp per=body"), "per=body is for"));
  EXPECT_TRUE(contains(trial.failure("export a.vtp values=length"), "not of edges"));
  EXPECT_TRUE(contains(trial.failure("export /no/such/folder/a.ply"), "/no/such/folder/a.ply"));
  EXPECT_FALSE(std::filesystem::exists("a.vtp"));
}

}  // namespace
}  // namespace lamella::trial
