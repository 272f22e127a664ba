#include "support/trial.h"

namespace lamella::trial {
namespace {

// Tests have no terminal: watching there must do nothing, and say so unless told to be quiet.
TEST(Watch, NeedsATerminal) {
  Trial trial("cube.fe");
  EXPECT_EQ(trial.out("watch; refine; g 2; watch off"), trial.out(""));
  trial.session().set_quiet(false);
  EXPECT_TRUE(contains(trial.out("watch on style=glass"), "no terminal"));
}

TEST(Watch, Refuses) {
  Trial trial("cube.fe");
  EXPECT_TRUE(contains(trial.failure("watch maybe"), "on|off"));
  EXPECT_TRUE(contains(trial.failure("watch color=area"), "their own colours"));
}

// The picture is drawn when a statement has changed the scene, and during steps.
TEST(Watch, FollowersAreCalled) {
  Trial trial("cube.fe");
  long steps = 0;
  long settled = 0;
  trial.session().follow_steps([&](const scene::Scene&, bool done) { (done ? settled : steps) += 1; });
  trial.out("refine");
  EXPECT_EQ(steps, 0);
  EXPECT_EQ(settled, 1);
  trial.out("print 1");
  EXPECT_EQ(settled, 1);
  trial.out("evolve 5");
  EXPECT_GE(steps, 5);
  EXPECT_EQ(settled, 2);
  trial.out("undo");
  EXPECT_EQ(settled, 3);
}

}  // namespace
}  // namespace lamella::trial
