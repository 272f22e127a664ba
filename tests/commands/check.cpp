#include <cmath>

#include "support/trial.h"

namespace lamella::trial {
namespace {

TEST(Check, TellsLikeEvolver) {
  Trial trial("double_bubble.fe");
  EXPECT_EQ(trial.out("check"), "");
  trial.session().set_quiet(false);
  EXPECT_EQ(trial.out("C"), "Checks completed.\n");
  EXPECT_EQ(trial.number("check_count"), 0);
}

TEST(Check, NamesWhatIsBroken) {
  Trial trial("cube.fe");
  film::Film& film = trial.session().scene().film;
  film.edit_positions()[4].x = std::nan("");
  const std::string messages = trial.failure("check");
  EXPECT_TRUE(contains(messages, "test:1:1: error: "));
  EXPECT_TRUE(contains(messages, "vertex 5"));
  EXPECT_GE(trial.number("check_count"), 1);
}

// Open bodies are lawful: the labels around their rims are told, and no more.
TEST(Check, TellsOfLabelsThatDoNotClose) {
  Trial trial("cube.fe");
  trial.session().set_quiet(false);
  const std::string told = trial.out("unset facet[1] frontbody; unset facet[1] backbody; check");
  EXPECT_TRUE(contains(told, "note: "));
  EXPECT_TRUE(contains(told, "Checks completed.\n"));
}

TEST(Check, FindsFilmsThatPassThroughOneAnother) {
  Trial trial("cube.fe");
  trial.out("refine; check");
  const std::string messages =
      trial.failure("set vertex[1] x 3; set vertex[1] y 0.3; set vertex[1] z 0.4; check");
  EXPECT_TRUE(contains(messages, "pass through one another"));
}

TEST(Check, TakesNothing) {
  Trial trial("cube.fe");
  EXPECT_TRUE(
      contains(trial.failure("check all"), "test:1:7: error: check takes no arguments, found \"all\""));
}

}  // namespace
}  // namespace lamella::trial
