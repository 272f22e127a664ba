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
  EXPECT_TRUE(contains(trial.failure("fix"), "fix and unfix take elements or the name of a parameter"));
}

TEST(Fix, TakesParameters) {
  Trial trial("drop_under_plate.fe");
  trial.session().set_quiet(false);
  EXPECT_EQ(trial.out("fix height; print height.fixed; fix height"), "fixed: 1\n1\nfixed: 0\n");
  EXPECT_EQ(trial.out("unfix height; print height.fixed; unfix weight"), "unfixed: 1\n0\nunfixed: 1\n");
  EXPECT_EQ(trial.out("print weight.fixed"), "0\n");
  EXPECT_TRUE(contains(trial.failure("fix heigt"), "height"));
}

}  // namespace
}  // namespace lamella::trial
