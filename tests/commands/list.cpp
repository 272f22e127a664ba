#include "support/trial.h"

namespace lamella::trial {
namespace {

TEST(List, ElementsAsLinesOfADatafile) {
  Trial trial("cube.fe");
  trial.out(
      "fix vertex[2]; set edge[3] color red; set facet[2] frontcolor blue; define vertex attribute heat "
      "real[2]");
  EXPECT_EQ(trial.out("list vertex[2]"),
            "// id                  x                  y                  z\n"
            "  2                  1                  0                  0 fixed heat {0, 0}\n");
  EXPECT_EQ(trial.out("list edges where id == 3"), "// id    ends\n  3       3    4 color 4  /*length 1*/\n");
  EXPECT_TRUE(contains(trial.out("list facets where id == 2"), " frontcolor 1 backcolor 15"));
  const std::string body = trial.out("list bodies");
  EXPECT_TRUE(contains(body, "  1   1 2 3 4 5 6 7 8 9 10 \\\n      11 12"));
  EXPECT_TRUE(contains(body, "volume 1  /*actual 1*/"));
}

// What is listed can stand in a datafile again.
TEST(List, CanBePastedIntoADatafile) {
  Trial trial("double_bubble.fe");
  const Folder folder;
  trial.out("set facet[3] color red; fix vertex[4]");
  const std::string file =
      folder.write("pasted.fe", "keep_originals\nvertices\n" + trial.out("list vertices") + "edges\n" +
                                    trial.out("list edges") + "faces\n" + trial.out("list facets") +
                                    "bodies\n" + trial.out("list bodies"));
  Trial other;
  other.session().load(file);
  for (const char* value :
       {"vertex_count", "facet_count", "facet[3].color", "vertex[4].fixed", "body[2].target"}) {
    EXPECT_EQ(other.number(value), trial.number(value)) << value;
  }
  EXPECT_NEAR(other.number("total_area"), trial.number("total_area"), 1e-13);
  EXPECT_NEAR(other.number("body[1].volume"), trial.number("body[1].volume"), 1e-13);
}

TEST(List, OtherThings) {
  Trial trial("cube.fe");
  EXPECT_EQ(trial.out("x := 0.5; s := \"a\"; list variables"),
            "edge_length := 1  // parameter\nx := 0.5\ns := \"a\"\n");
  trial.out("procedure p(real a) { print a }\nfunction real f() { return 1 }");
  EXPECT_TRUE(contains(trial.out("list procedures"), "procedure p(real a) { print a }\n"));
  EXPECT_TRUE(contains(trial.out("list procedures"), "function real f() { return 1 }\n"));
  EXPECT_TRUE(contains(trial.out("list attributes"), "body: volume, target"));
  EXPECT_TRUE(contains(trial.failure("list"), "list needs to know what"));
  EXPECT_TRUE(contains(trial.failure("list nonsense"), "list does not take"));
}

TEST(List, TopAndBottomOfTheDatafile) {
  Trial trial("cube.fe");
  trial.out("gravity_constant := 3; x := 5");
  EXPECT_TRUE(contains(trial.out("list topinfo"), "gravity_constant 3\n"));
  EXPECT_FALSE(contains(trial.out("list topinfo"), "vertices"));
  EXPECT_TRUE(trial.out("list bottominfo").starts_with("read\n"));
  EXPECT_TRUE(contains(trial.out("list bottominfo"), "x := 5\n"));
}

}  // namespace
}  // namespace lamella::trial
