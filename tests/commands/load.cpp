#include "support/trial.h"

namespace lamella::trial {
namespace {

TEST(Load, ReplacesTheScene) {
  Trial trial("cube.fe");
  trial.session().set_quiet(false);
  const std::string file = datafile("double_bubble.fe");
  EXPECT_EQ(trial.out("x := 1; load \"" + file + "\""),
            file + ": 33 vertices, 96 edges, 66 facets, 2 bodies\n");
  EXPECT_EQ(trial.number("body_count"), 2);
  EXPECT_EQ(trial.number("is_defined(\"gogo\") + is_defined(\"edge_length\")"), 1);
}

TEST(Load, AFileThatCannotBeReadLeavesTheSceneAlone) {
  Trial trial("cube.fe");
  const Folder folder;
  EXPECT_TRUE(contains(trial.failure("load " + folder.write("bad.fe", "vertices\n1 0 0\n")), "bad.fe:2:"));
  EXPECT_TRUE(contains(trial.failure("load " + (folder / "none.fe")), "test:1:6: error: cannot read"));
  const std::string read =
      "vertices\n1 0 0 0\n2 1 0 0\n3 0 1 0\nedges\n1 1 2\n2 2 3\n3 3 1\nfaces\n1 1 2 3\nread\nx := "
      "1\nrefnie\n";
  EXPECT_TRUE(contains(trial.failure("load " + folder.write("read.fe", read)), "read.fe:13:1: error"));
  EXPECT_EQ(trial.number("vertex_count"), 14);
  EXPECT_EQ(trial.number("is_defined(\"x\")"), 0);
}

}  // namespace
}  // namespace lamella::trial
