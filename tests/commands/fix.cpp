#include "support/trial.h"

namespace lamella::trial {
namespace {

TEST(Fix, CountsWhatIsNewlyFixed) {
  Trial trial("cube.fe");
  trial.session().set_quiet(false);
  EXPECT_EQ(trial.out("fix vertices where z == 1"), "fixed: 5\n");
  EXPECT_EQ(trial.number("fix_count"), 5);
  EXPECT_EQ(trial.out("fix vertex"), "fixed: 9\n");
  EXPECT_EQ(trial.out("fix edge[1]; print edge[1].fixed; fix facet[2].edge; print count(edge where fixed)"),
            "fixed: 1\n1\nfixed: 3\n4\n");
}

TEST(Fix, RefusesBodies) {
  Trial trial("cube.fe");
  EXPECT_TRUE(contains(trial.failure("fix body[1]"), "set body[1] target"));
  EXPECT_TRUE(contains(trial.failure("fix"), "fix needs elements"));
}

}  // namespace
}  // namespace lamella::trial
