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
  EXPECT_EQ(trial.number("vertex_count"), 14);
}

constexpr const char* triangle =
    "vertices\n1 0 0 0\n2 1 0 0\n3 0 1 0\nedges\n1 1 2\n2 2 3\n3 3 1\nfaces\n1 1 2 3\nread\n";

TEST(Load, LeavesOutCommandsThatCannotBeRun) {
  Trial trial("cube.fe");
  const Folder folder;
  const std::string commands =
      "refnie\none := { r;\n frobnicate }\ntwo := { r }\nprint 1/0; three := 3\nset vertex z 2\n";
  const Ran ran = trial.run("load \"" + folder.write("read.fe", triangle + commands) + "\"");
  EXPECT_EQ(ran.outcome, session::Outcome::done);
  EXPECT_TRUE(contains(ran.messages,
                       "read.fe:12:1: warning: there is no command \"refnie\"; this command is left out"));
  EXPECT_TRUE(contains(ran.messages, "read.fe:14:2: warning: there is no command \"frobnicate\""));
  EXPECT_TRUE(contains(ran.messages, "warning: division by zero"));
  EXPECT_EQ(trial.number("is_defined(\"one\")"), 0);
  EXPECT_EQ(trial.number("is_defined(\"two\")"), 1);
  EXPECT_EQ(trial.number("three"), 3);
  EXPECT_EQ(trial.number("vertex[3].z"), 2);
}

TEST(Load, StopsCommandsWhereAFileIsMissing) {
  Trial trial("cube.fe");
  const Folder folder;
  const std::string commands = "set vertex z 2\nread \"none.cmd\"\nset vertex z 3\n";
  const Ran ran = trial.run("load \"" + folder.write("read.fe", triangle + commands) + "\"");
  EXPECT_TRUE(contains(ran.messages, "cannot read"));
  EXPECT_TRUE(contains(ran.messages, "the rest of the datafile's commands is left out too"));
  EXPECT_EQ(trial.number("vertex[3].z"), 2);
}

}  // namespace
}  // namespace lamella::trial
