#include "support/trial.h"

namespace lamella::trial {
namespace {

TEST(Import, BringsBackWhatWasExported) {
  Trial trial("double_bubble.fe");
  const Folder folder;
  trial.out("refine 2; relax");
  const double area = trial.number("total_area");
  const double volume = trial.number("body[2].volume");
  trial.out("export \"" + (folder / "a.stl") + "\"");
  trial.out("import \"" + (folder / "a.stl") + "\"");
  EXPECT_NEAR(trial.number("total_area"), area, 1e-5);
  EXPECT_NEAR(trial.number("body[2].volume"), volume, 1e-5);
  trial.out("relax");  // the bodies keep their volumes
  EXPECT_NEAR(trial.number("body[2].volume"), volume, 1e-5);
  trial.out("undo 2");
  EXPECT_NEAR(trial.number("total_area"), area, 1e-12);
}

TEST(Import, TellsWhatItDid) {
  Trial trial("cube.fe");
  const Folder folder;
  const std::string path =
      folder.write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 1 0\nf 1 2 3\nf 1 2 4\nf 1 1 2\n");
  trial.session().set_quiet(false);
  const std::string told = trial.out("import \"" + path + "\"");
  EXPECT_TRUE(contains(told, "3 vertices, 3 edges, 1 facets, 0 bodies found from the geometry"));
  EXPECT_TRUE(contains(told, "1 points lay within"));
  EXPECT_TRUE(contains(told, "1 facets without area"));
  EXPECT_TRUE(contains(told, "1 facets lay upon others"));
  EXPECT_TRUE(contains(told, "3 edges of wires and rims are fixed"));
}

TEST(Import, LeavesTheSceneAloneWhereItFails) {
  Trial trial("cube.fe");
  const Folder folder;
  const std::string path = folder.write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 7\n");
  EXPECT_TRUE(contains(trial.failure("import \"" + path + "\""), "a.obj:4:7"));
  EXPECT_EQ(trial.number("total_area"), 6);
  EXPECT_TRUE(contains(trial.failure("import nothing.obj"), "nothing.obj"));
  EXPECT_TRUE(contains(trial.failure("import cube.fe"), "load FILE.fe"));
}

}  // namespace
}  // namespace lamella::trial
