#include "support/trial.h"

namespace lamella::trial {
namespace {

TEST(On, RunsCommandsWhenSomethingHappens) {
  Trial trial("double_bubble.fe");
  trial.out("count_of := 0; on burst { count_of := count_of + 1 }");
  EXPECT_EQ(trial.out("on burst"), "on burst runs commands\n");
  trial.out("burst facet[1]");
  EXPECT_EQ(trial.number("count_of"), 1);
  trial.out("on burst off; burst body[1]");
  EXPECT_EQ(trial.number("count_of"), 1);
  EXPECT_EQ(trial.out("on burst"), "on burst off\n");
}

TEST(On, KnowsItsEvents) {
  Trial trial("cube.fe");
  EXPECT_TRUE(contains(trial.failure("on rain { print 1 }"), "rain"));
}

}  // namespace
}  // namespace lamella::trial
