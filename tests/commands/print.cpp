#include "support/trial.h"

namespace lamella::trial {
namespace {

TEST(Print, NumbersStringsArraysAndProcedures) {
  Trial trial("cube.fe");
  EXPECT_EQ(trial.out("print pi"), "3.14159265358979\n");
  EXPECT_EQ(trial.out("print 2/3*3; print 1e20; print -0.5; print 100000"), "2\n1e+20\n-0.5\n100000\n");
  EXPECT_EQ(trial.out("print \"foam\"; print \"line\\n\""), "foam\nline\n");
  EXPECT_EQ(trial.out("print total_area > 3; print 1 = 2"), "1\n-1\n");
  EXPECT_EQ(trial.out("define vertex attribute m real[2][2]; print vertex[1].m; print vertex[1].m[2]"),
            "{{0, 0},\n {0, 0}}\n{0, 0}\n");
  EXPECT_EQ(trial.out("go := { print 1; /* and */ print 2 }\nprint go"), "{ print 1; /* and */ print 2 }\n");
  EXPECT_TRUE(contains(trial.failure("print"), "print needs"));
}

}  // namespace
}  // namespace lamella::trial
