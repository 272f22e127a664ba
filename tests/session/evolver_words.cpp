// Words of scripts written for Surface Evolver: done, accepted, or refused by name and place.
#include "support/trial.h"

namespace lamella::trial {
namespace {

TEST(EvolverWords, SwitchesAreCommandsAndValues) {
  Trial trial("cube.fe");
  trial.session().set_quiet(false);
  EXPECT_EQ(trial.out("gravity off"), "Gravity OFF. (was on)\n");
  EXPECT_EQ(trial.out("print gravity; gravity; print gravity"), "0\nGravity ON. (was off)\n1\n");
  EXPECT_EQ(trial.out("autorecalc off; if autorecalc then print 1 else print 2"), "2\n");
  EXPECT_EQ(trial.out("show_inner := 0; print show_inner; PS_COLORFLAG; print ps_colorflag"), "0\n1\n");
  EXPECT_EQ(trial.out("area_normalization off; autopop off"), "");
}

TEST(EvolverWords, SwitchesThatWouldChangeStepsAreRefused) {
  Trial trial("cube.fe");
  EXPECT_TRUE(
      contains(trial.failure("r; autopop on"),
               "test:1:4: error: autopop is not supported: nothing is popped or collapsed on its own"));
  EXPECT_TRUE(contains(trial.failure("a"), "area_normalization is not supported"));
  EXPECT_TRUE(contains(trial.failure("ambient_pressure := 1"), "ambient_pressure is not supported"));
  EXPECT_EQ(trial.number("facet_count"), 96);
}

TEST(EvolverWords, QuietIsQuiet) {
  Trial trial("cube.fe");
  trial.session().set_quiet(false);
  EXPECT_EQ(trial.out("quiet on; r; quiet off"), "Quiet OFF. (was on)\n");
}

// A procedure may speak of what is not supported; who runs it is told where that stands.
TEST(EvolverWords, RefusedCommandsWaitForTheirTurn) {
  Trial trial("cube.fe");
  trial.out(
      "popper := { r; pop_quad_to_quad edge[3] where (valence == 3); print 5 }; other := { detorus; O }");
  const std::string message = trial.failure("popper");
  EXPECT_TRUE(contains(message, "test:1:16: error: pop_quad_to_quad is not supported: pop_tri_to_edge"))
      << message;
  EXPECT_EQ(trial.number("facet_count"), 24);
  EXPECT_TRUE(contains(trial.failure("other"), "detorus is not supported"));
  EXPECT_TRUE(contains(trial.failure("if 1 then quadratic else r"), "quadratic is not supported"));
  EXPECT_EQ(trial.out("if 0 then quadratic else print 2"), "2\n");
}

TEST(EvolverWords, SetGivesVariablesValuesToo) {
  Trial trial("cube.fe");
  EXPECT_EQ(trial.out("set background white; print background; x := 1; set x 3*x; print x"), "15\n3\n");
}

TEST(EvolverWords, LettersWithNumbersStuckToThem) {
  Trial trial("cube.fe");
  trial.out("r2; u3");
  EXPECT_EQ(trial.number("facet_count"), 24 * 16);
  trial.out("g5 := { print 7 }");
  EXPECT_EQ(trial.out("g5"), "7\n");
  EXPECT_TRUE(contains(trial.failure("y5"), "there is no command \"y5\""));
}

TEST(EvolverWords, WhatBelongsIntoTheDatafileIsRefused) {
  Trial trial("cube.fe");
  EXPECT_TRUE(
      contains(trial.failure("r; { define constraint wall formula: z = 0\n energy:\n e1: -y/2 }; r"),
               "test:1:6: error: define is not supported: constraints, boundaries and quantities stand"));
  EXPECT_EQ(trial.number("facet_count"), 24 * 4);
}

TEST(EvolverWords, LettersNeedTheirArguments) {
  Trial trial("cube.fe");
  for (const char* const letter : {"t", "l", "w", "K", "n", "k", "Z"}) {
    EXPECT_TRUE(contains(trial.failure(letter), std::string(letter) + " needs ")) << letter;
  }
  for (const char* const letter : {"A", "b", "X", "y", "z", "p", "f"}) {
    EXPECT_TRUE(contains(trial.failure(letter), std::string(letter) + " is not supported: ")) << letter;
  }
}

TEST(EvolverWords, LettersCanBeRedefined) {
  Trial trial("cube.fe");
  trial.out("n := 0; r :::= { n := n + 1; 'r' }; r; r 2");
  EXPECT_EQ(trial.number("n"), 3);
  EXPECT_EQ(trial.number("facet_count"), 24 * 64);
  trial.out("undo 2\n'r'");
  EXPECT_EQ(trial.number("n"), 0);
  EXPECT_EQ(trial.number("facet_count"), 96);
  EXPECT_TRUE(contains(trial.out("list procedures"), "r :::= { n := n + 1; 'r' }\n"));
  trial.out("V :::= { print 5 }");
  EXPECT_EQ(trial.out("V"), "5\n");
  EXPECT_EQ(trial.out("V :::=\nV\nprint is_defined(\"V\")"), "1\n");
  const Folder folder;
  trial.out("save \"" + (folder / "kept.fe") + "\"");
  EXPECT_TRUE(contains(file_content(folder / "kept.fe"), "\nr :::= { n := n + 1; 'r' }\n"));
  trial.out("load \"" + datafile("cube.fe") + "\"; r");
  EXPECT_EQ(trial.number("facet_count"), 96);
}

TEST(EvolverWords, PermanentVariablesOutliveTheScene) {
  Trial trial("cube.fe");
  trial.out("kept ::= 3; lost := 4; kept2 :::= \"text\"; load \"" + datafile("catenoid.fe") + "\"");
  EXPECT_EQ(trial.number("kept"), 3);
  EXPECT_EQ(trial.out("print kept2"), "text\n");
  EXPECT_EQ(trial.number("is_defined(\"lost\")"), 0);
}

TEST(EvolverWords, ElementsAreMade) {
  Trial trial("cube.fe");
  EXPECT_EQ(trial.number("new_vertex(1, 2, 3)"), 15);
  trial.out(
      "va := new_vertex(2,2,4); vb := new_vertex(3,2,4); vc := new_vertex(3,3,4); vd := new_vertex(2,3,4)");
  trial.out("e1 := new_edge(va,vb); e2 := new_edge(vb,vc); e3 := new_edge(vc,vd); e4 := new_edge(vd,va)");
  EXPECT_EQ(trial.number("e1"), 37);
  EXPECT_EQ(trial.number("new_facet(e1, e2, e3, e4)"), 25);
  EXPECT_EQ(trial.number("facet_count"), 28);
  EXPECT_EQ(trial.number("count(facet where original == 25)"), 4);
  EXPECT_EQ(trial.number("sum(facet where original == 25, area)"), 1);
  EXPECT_EQ(trial.number("new_body"), 2);
  trial.out("set facet frontbody 2 where original == 25; new_edge(va, vc)");
  EXPECT_EQ(trial.number("body[2].valence"), 4);
  EXPECT_EQ(trial.out("check; print check_count"), "0\n");
}

TEST(EvolverWords, ElementsThatCannotBe) {
  Trial trial("cube.fe");
  EXPECT_TRUE(contains(trial.failure("print new_edge(1, 99)"), "there is no vertex 99"));
  EXPECT_TRUE(contains(trial.failure("print new_edge(1, 1)"), "these are one"));
  EXPECT_TRUE(contains(trial.failure("print new_facet(1, 2, 5)"), "does not begin where edge"));
  EXPECT_TRUE(
      contains(trial.failure("print new_facet(1, 2)"), "new_facet takes at least 3 arguments, not 2"));
  EXPECT_TRUE(contains(trial.failure("print new_vertex(1, 2)"), "new_vertex takes 3 arguments, not 2"));
  EXPECT_EQ(trial.number("edge_count"), 36);
}

// What a datafile's own commands cannot do is told with its place; the rest runs.
TEST(EvolverWords, DatafilesLoadWithoutWhatFails) {
  const Folder folder;
  const std::string path =
      folder.write("some.fe", file_content(datafile("cube.fe")) +
                                  "\nr\nnonsense 5; x := 1\npop_quad_to_quad edge[1]\nshow facets\n"
                                  "broken := { g 5; nonsense }\ny := 2\nset vertex[99] x 1\n");
  Trial trial;
  trial.session().set_quiet(false);
  const Ran ran = trial.run("load \"" + path + "\"");
  EXPECT_EQ(ran.outcome, session::Outcome::done);
  EXPECT_TRUE(contains(ran.messages, "warning: there is no command \"nonsense\"")) << ran.messages;
  EXPECT_TRUE(contains(ran.messages, "warning: pop_quad_to_quad is not supported"));
  EXPECT_TRUE(contains(ran.messages, "warning: there is no vertex 99"));
  EXPECT_TRUE(contains(ran.out, "4 of the commands at its end were left out\n")) << ran.out;
  EXPECT_EQ(trial.number("facet_count"), 96);
  EXPECT_EQ(trial.number("y"), 2);
  EXPECT_EQ(trial.number("is_defined(\"x\")"), 0);
}

}  // namespace
}  // namespace lamella::trial
