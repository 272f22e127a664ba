#include "support/trial.h"

namespace lamella::trial {
namespace {

TEST(Statements, SeparatedBySemicolonsAndLines) {
  Trial trial;
  EXPECT_EQ(trial.out("print 1; print 2\nprint 3;;\n\n;print 4"), "1\n2\n3\n4\n");
  EXPECT_EQ(trial.out("print 1 /* a\n b */; print 2 // print 3\nprint \\\n 4"), "1\n2\n4\n");
}

TEST(Statements, Assignments) {
  Trial trial;
  EXPECT_EQ(trial.out("x := 3; x += 2; x *= 4; x -= 2; x /= 9; print x"), "2\n");
  EXPECT_EQ(trial.out("n := 1; n++; ++n; n--; print n"), "2\n");
  EXPECT_EQ(trial.out("name := \"foam\"; print name; name := 4; print name"), "foam\n4\n");
  EXPECT_EQ(trial.out("e := 5; print e; X := 7; print x"), "5\n7\n");
  EXPECT_EQ(trial.out("scale := 0.25; print scale"), "0.25\n");
}

TEST(Statements, If) {
  Trial trial;
  EXPECT_EQ(trial.out("if 1 then print 1 else print 2"), "1\n");
  EXPECT_EQ(trial.out("if 0 then print 1 else print 2"), "2\n");
  EXPECT_EQ(trial.out("if (0) { print 1 } else { print 2 }"), "2\n");
  EXPECT_EQ(trial.out("if 0 then print 1\nelse print 2"), "2\n");
  EXPECT_EQ(trial.out("if 1 then print 1; else print 2"), "1\n");
  EXPECT_EQ(trial.out("if 1 then\n  print 1\nprint 3"), "1\n3\n");
  EXPECT_EQ(trial.out("if 0 then print 1 else if 0 then print 2 else print 3"), "3\n");
  EXPECT_EQ(trial.out("if 1 then if 0 then print 1 else print 2"), "2\n");
}

TEST(Statements, Loops) {
  Trial trial;
  EXPECT_EQ(trial.out("i := 0; while i < 3 do { print i; i++ }"), "0\n1\n2\n");
  EXPECT_EQ(trial.out("i := 5; do { print i; i++ } while i < 3"), "5\n");
  EXPECT_EQ(trial.out("for (i := 0; i < 3; i++) print i"), "0\n1\n2\n");
  EXPECT_EQ(trial.out("for ({i := 1; f := 1}; i < 6; i++) { f *= i }; print f"), "120\n");
  EXPECT_EQ(trial.out("i := 0; while 1 do { i++; if i == 2 then continue; if i > 3 then break; print i }"),
            "1\n3\n");
  EXPECT_EQ(
      trial.out(
          "for (i := 0; i < 3; i++) for (j := 0; j < 3; j++) { if j == 1 then continue 2; print 10*i+j }"),
      "0\n10\n20\n");
  EXPECT_EQ(
      trial.out("for (i := 0; i < 3; i++) for (j := 0; j < 3; j++) { if i == 1 then break 2; print 10*i+j }"),
      "0\n1\n2\n");
  EXPECT_EQ(trial.out("n := 0; { n++ } 10; print n"), "10\n");
  EXPECT_EQ(trial.out("{ print 1; { print 2 } 2 } 2"), "1\n2\n2\n1\n2\n2\n");
}

TEST(Statements, Procedures) {
  Trial trial;
  EXPECT_EQ(trial.out("go := { print 1 }; go; go 2"), "1\n1\n1\n");
  EXPECT_EQ(trial.out("go1 := print 5; go1"), "5\n");
  EXPECT_EQ(trial.out("procedure show_sum(real a, integer b) { print a+b }\nshow_sum(1.5, 2)"), "3.5\n");
  EXPECT_EQ(
      trial.out("function real factorial(integer n) { if n <= 1 then return 1; return n*factorial(n-1) }\n"
                "print factorial(10)"),
      "3628800\n");
  EXPECT_EQ(
      trial.out(
          "procedure later(real a);\nuses := { later(3) }\nprocedure later(real a) { print a*2 }\nuses"),
      "6\n");
  EXPECT_EQ(trial.out("early := { print 1; return; print 2 }; early; print 3"), "1\n3\n");
  EXPECT_EQ(trial.out("again := { again := { print 2 }; print 1 }; again; again"), "1\n2\n");
}

TEST(Statements, LocalNamesStayInside) {
  Trial trial;
  EXPECT_EQ(trial.out("x := 1; tt := { local x; x := 5; print x }; tt; print x"), "5\n1\n");
  EXPECT_EQ(trial.out("{ local y; y := 2; { local y; y := 3; print y }; print y }"), "3\n2\n");
  EXPECT_EQ(trial.out("function real fib(integer n) { local a; if n < 2 then return n; a := fib(n-1); return "
                      "a + fib(n-2) }\n"
                      "print fib(12)"),
            "144\n");
  EXPECT_TRUE(contains(trial.failure("{ local z; z := 1 }; print z"), "\"z\" is not defined"));
}

TEST(Statements, NamesAreKnownFromWhereTheyAreAssigned) {
  Trial trial;
  EXPECT_EQ(trial.out("if 0 then later := 3\nprint is_defined(\"later\")"), "0\n");
  EXPECT_TRUE(contains(trial.failure("print later"), "is not defined"));
  EXPECT_TRUE(contains(trial.failure("own := own + 1"), "is not defined"));
}

TEST(Statements, ForeachAndWhere) {
  Trial trial("cube.fe");
  EXPECT_EQ(trial.out("foreach vertex vv where vv.id < 3 do print vv.x"), "0\n1\n");
  EXPECT_EQ(trial.out("foreach vertex where id < 3 do print x"), "0\n1\n");
  EXPECT_EQ(trial.out("foreach facet[1].edge ee do printf \"%d \", ee.oid"),
            trial.out("foreach facet ff where ff.id == 1 do foreach ff.edge do printf \"%d \", oid"));
  EXPECT_EQ(trial.out("foreach edge[1].vertex vv do print vv.id"), "1\n2\n");
  EXPECT_EQ(trial.out("foreach edge[-1].vertex vv do print vv.id"), "2\n1\n");
  EXPECT_EQ(trial.out("n := 0; foreach vertex vv do foreach vv.edge ee do n++; print n - 2*edge_count"),
            "0\n");
  EXPECT_EQ(trial.out("foreach vertex[3] do print id"), "3\n");
}

TEST(Statements, TheElementInTurnGoesBeforeVariablesAndInnerNamesBeforeIt) {
  Trial trial("cube.fe");
  EXPECT_EQ(trial.out("x := 77; foreach vertex where id == 2 do print x; print x"), "1\n77\n");
  EXPECT_EQ(trial.out("foreach vertex where id == 2 do { local x; x := 3; print x }"), "3\n");
  EXPECT_EQ(trial.out("tt := { local x; x := 3; foreach vertex where id == 2 do print x }; tt"), "1\n");
  EXPECT_EQ(trial.out("foreach vertex vv where id == 2 do foreach edge where id == 1 do print vv.id"), "2\n");
}

TEST(Statements, ElementsMadeInALoopAreNotMet) {
  Trial trial("cube.fe");
  EXPECT_EQ(trial.out("n := 0; foreach edge ee do { n++; if n == 3 then refine edge[5] }; print n"), "36\n");
}

TEST(Statements, Aggregates) {
  Trial trial("cube.fe");
  EXPECT_EQ(trial.number("count(vertex)"), 14);
  EXPECT_EQ(trial.number("count(vertex where z == 1, 1)"), 5);
  EXPECT_NEAR(trial.number("sum(facet, area)"), 6, 1e-12);
  EXPECT_EQ(trial.number("max(vertex, x + y)"), 2);
  EXPECT_EQ(trial.number("min(vertex vv where vv.id > 1, vv.id)"), 2);
  EXPECT_EQ(trial.number("avg(vertex where id <= 3, id)"), 2);
  EXPECT_EQ(trial.number("max(vertex[2].x, 0.5)"), 1);
  EXPECT_EQ(trial.number("max(vertex[2].edge, 1)"), 1);
  EXPECT_EQ(trial.number("sum(facet ff, sum(ff.edge, 1))"), 72);
}

TEST(Statements, RepeatedReadingOfBodyVolumesIsCheap) {
  Trial trial("lattice.fe");
  EXPECT_EQ(trial.number("body_count"), 8);
  trial.out("for (i := 0; i < 20000; i++) v := body[1 + (i % 8)].volume");
}

}  // namespace
}  // namespace lamella::trial
