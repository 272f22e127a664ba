#include "session/interrupt.h"
#include "support/trial.h"

namespace lamella::trial {
namespace {

struct Case {
  const char* text;
  const char* place;  // line:column
  const char* says;
};

TEST(Errors, AreShownWhereTheyStandWithWhatWouldBeRight) {
  Trial trial("cube.fe");
  const Case cases[] = {
      {"refnie", "1:1", "did you mean \"refine\"?"},
      {"print foo", "1:7", "\"foo\" is not defined"},
      {"print total_ara", "1:7", "did you mean \"total_area\"?"},
      {"print vertex[1].lenth", "1:17", "vertices have no attribute"},
      {"print edge[1].lenth", "1:15", "did you mean \"length\"?"},
      {"print vertex[99].x", "1:7", "there is no vertex 99"},
      {"print vertex[0].x", "1:7", "there is no vertex 0"},
      {"print facet[1].edge[4].id", "1:16", "there are 3"},
      {"print vertex", "1:7", "vertex[1]"},
      {"print vertex[1]", "1:7", "vertex[1].id"},
      {"print 1 +* 2", "1:10", "expected a value after \"+\""},
      {"print 1 2", "1:9", "semicolons"},
      {"print (1", "1:7", "missing \")\""},
      {"{ print 1", "1:1", "missing \"}\""},
      {"foreach vertex do {\n print x\n", "1:19", "missing \"}\""},
      {"print 1 }", "1:9", "closes nothing"},
      {"{ print 1 print 2 }", "1:11", "semicolon"},
      {"print 1/0", "1:8", "division by zero"},
      {"else print 1", "1:1", "no if"},
      {"break", "1:1", "0 loops"},
      {"while 1 do break 2", "1:12", "1 loop"},
      {"total_area := 3", "1:12", "cannot be set"},
      {"facet[1].area := 3", "1:15", "cannot be set"},
      {"vertex := 3", "1:1", "word of the language"},
      {"x := 1; x", "1:9", "print x shows it"},
      {"evolve 5 td=0.1", "1:10", "did you mean \"dt\"?"},
      {"evolve 5 dt", "1:10", "needs its value"},
      {"evolve -1", "1:8", "at least 0"},
      {"evolve 1.5", "1:8", "whole number"},
      {"evolve 1 dt=0", "1:13", "greater than 0"},
      {"quit now", "1:6", "takes no arguments"},
      {"vertex[1].x := \"a\"", "1:16", "number"},
      {"s := \"a\"; s += 1", "1:13", "string"},
      {"procedure p(real a) { }\np(1,2)", "2:1", "takes 1 argument"},
      {"print sizeof(", "1:14", "expected a value"},
      {"show_me := 3; print shwo_me", "1:21", "show_me"},
      {"set vertex fixd", "1:12", "did you mean \"fixed\"?"},
      {"r := { g }", "1:1", "give procedures longer names"},
      {"print $", "1:7", "unexpected character"},
      {"if 1 > \"a\" then print 1", "1:8", "a number is needed"},
      {"vc 1 -1", "1:6", "-1"},
      {"x := 1; x --y", "1:9", "is a value"},
      {"quit --now", "1:6", "takes no arguments"},
      {"if 1 then", "1:10", "expected a command"},
      {"foreach vertx do print 1", "1:9", "expected vertices"},
  };
  for (const Case& each : cases) {
    const Ran ran = trial.run(each.text);
    EXPECT_EQ(ran.outcome, session::Outcome::failed) << each.text;
    EXPECT_TRUE(contains(ran.messages, std::string("test:").append(each.place).append(": error")))
        << each.text;
    EXPECT_TRUE(contains(ran.messages, each.says)) << each.text;
  }
}

TEST(Errors, AStatementThatFailsLeavesTheSceneAsItWas) {
  Trial trial("cube.fe");
  const double area = trial.number("total_area");
  trial.failure(
      "{ refine; vertex[1].x := 5; newname := 3; mygo := { print 1 }; set vertex fixed; print 1/0 }");
  EXPECT_EQ(trial.number("total_area"), area);
  EXPECT_EQ(trial.number("vertex_count"), 14);
  EXPECT_EQ(trial.number("vertex[1].x"), 0);
  EXPECT_EQ(trial.number("count(vertex where fixed)"), 0);
  EXPECT_EQ(trial.number("is_defined(\"newname\") + is_defined(\"mygo\")"), 0);
}

TEST(Errors, WhatCameBeforeOnTheLineStays) {
  Trial trial("cube.fe");
  trial.failure("x := 1; x := 2; x := 1/0; x := 4");
  EXPECT_EQ(trial.number("x"), 2);
}

TEST(Errors, AMistypedLineIsNotRunAtAll) {
  Trial trial("cube.fe");
  trial.failure("refine; refnie");
  EXPECT_EQ(trial.number("vertex_count"), 14);
}

TEST(Errors, NamesThatACommandBringsAreKnownOnTheSameLine) {
  Trial trial;
  EXPECT_EQ(trial.out("load \"" + datafile("cube.fe") + "\"; print edge_length; gogo := { print 1 }"), "1\n");
}

TEST(Errors, TheRestIsNotRunUnlessItIsWanted) {
  Trial trial;
  EXPECT_EQ(trial.run("print 1\nprint foo\nprint 2").out, "1\n");
  const Ran ran = trial.run(
      "print 1\nfor (i := 0; i < 2; i++) {\n print foo;\n print 3\n}\nprint 2; print 1/0; print 4", true);
  EXPECT_EQ(ran.out, "1\n2\n4\n");
  EXPECT_EQ(ran.outcome, session::Outcome::failed);
}

TEST(Errors, RunawayRecursionIsAnError) {
  Trial trial;
  EXPECT_TRUE(contains(trial.failure("loop := { loop }; loop"), "calls itself without end"));
  EXPECT_TRUE(contains(trial.failure("function real f(real a) { return 1 + (2*f(a+1)) }\nprint f(1)"),
                       "calls itself without end"));
  EXPECT_TRUE(contains(trial.failure("ping := {}; pong := { ping }; ping := { pong }; ping"),
                       "calls itself without end"));
}

TEST(Errors, DeepNestingIsAnError) {
  Trial trial;
  EXPECT_TRUE(contains(trial.failure(std::string(100000, '{') + std::string(100000, '}')), "nested"));
  std::string ifs;
  for (int i = 0; i < 100000; ++i) ifs += "if 1 then ";
  EXPECT_TRUE(contains(trial.failure(ifs + "print 1"), "nested"));
}

TEST(Errors, LastErrorIsKept) {
  Trial trial;
  EXPECT_EQ(trial.session().last_error(), "");
  trial.failure("refnie");
  EXPECT_TRUE(contains(trial.session().last_error(), "refine"));
  EXPECT_EQ(trial.out("help error"), trial.session().last_error());
}

// Ctrl-C is pressed before the loop begins, so that nothing depends on time.
TEST(Interrupt, EndsTheStatementAndKeepsTheScene) {
  Trial trial("cube.fe");
  session::interrupt::watch();
  trial.out("n := 0");
  session::interrupt::request();
  const Ran ran = trial.run("while 1 do { n++ }; n := 100");
  session::interrupt::clear();
  EXPECT_EQ(ran.outcome, session::Outcome::interrupted);
  EXPECT_TRUE(contains(ran.messages, "Ctrl-C"));
  EXPECT_LT(trial.number("n"), 100);
}

}  // namespace
}  // namespace lamella::trial
