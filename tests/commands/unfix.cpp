#include "support/trial.h"

namespace lamella::trial {
namespace {

TEST(Unfix, CountsWhatIsFreed) {
  Trial trial("cube.fe");
  trial.session().set_quiet(false);
  trial.out("fix vertices where z == 1");
  EXPECT_EQ(trial.out("unfix vertices where x == 1"), "unfixed: 2\n");
  EXPECT_EQ(trial.number("unfix_count"), 2);
  EXPECT_EQ(trial.number("count(vertex where fixed)"), 3);
}

}  // namespace
}  // namespace lamella::trial
