#include "support/trial.h"

namespace lamella::trial {
namespace {

TEST(Define, VariablesKeepTheirValues) {
  Trial trial;
  EXPECT_EQ(trial.out("define n integer; define r real; define s string; print n + r; print sizeof(s)"),
            "0\n0\n");
  EXPECT_EQ(trial.out("n := 5; define n integer; print n"), "5\n");
}

TEST(Define, Attributes) {
  Trial trial("cube.fe");
  EXPECT_EQ(trial.out("define facet attribute mark integer; print facet[1].mark"), "0\n");
  EXPECT_EQ(trial.out("size := 2; define body attribute history real[size]; body[1].history[2] := 7; print "
                      "body[1].history"),
            "{0, 7}\n");
  EXPECT_EQ(trial.out("define body attribute history real[3]; print body[1].history"), "{0, 7, 0}\n");
}

TEST(Define, Refuses) {
  Trial trial("cube.fe");
  EXPECT_TRUE(contains(trial.failure("define vertex attribute x real"), "already"));
  EXPECT_TRUE(contains(trial.failure("define n rael"), "is no type"));
  EXPECT_TRUE(contains(trial.failure("define vertex attribute n real[0]"), "not possible"));
  EXPECT_TRUE(contains(trial.failure("define vertex attribute n string"), "real or integer"));
}

}  // namespace
}  // namespace lamella::trial
