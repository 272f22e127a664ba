#include "support/trial.h"

namespace lamella::trial {
namespace {

TEST(Vc, SetsATargetAtOnce) {
  Trial trial("double_bubble.fe");
  trial.session().set_quiet(false);
  const std::string told = trial.out("vc 1 2");
  EXPECT_TRUE(
      told.starts_with("Body          target volume           actual volume          pressure\n"
                       "  1                       2 "))
      << told;
  EXPECT_NEAR(trial.number("body[1].volume"), 2, 1e-12);
  EXPECT_NEAR(trial.number("body[2].volume"), 1, 1e-12);
  EXPECT_EQ(trial.number("body[1].target"), 2);
  trial.out("undo");
  EXPECT_EQ(trial.number("body[1].target"), 1);
}

// Films stay in their order around every border, however far the volume goes.
TEST(Vc, LargeChangesDoNotFoldFilms) {
  for (const char* volume : {"0.01", "0.5", "2", "100"}) {
    Trial trial("double_bubble.fe");
    trial.out("refine 2; relax");
    trial.out("vc 1 " + std::string(volume));
    EXPECT_EQ(trial.out("check; print check_count"), "0\n") << volume;
    EXPECT_NEAR(std::stod(trial.out("print body[1].volume")) / std::stod(volume), 1, 1e-11);
    EXPECT_NEAR(std::stod(trial.out("print body[2].volume")), 1, 1e-11);
  }
}

TEST(Vc, AloneRestoresAndReports) {
  Trial trial("cube.fe");
  trial.session().set_quiet(false);
  const std::string told = trial.out("set vertex z 1.3 where z == 1; vc");
  EXPECT_TRUE(contains(told, "  1                       1 "));
  EXPECT_NEAR(trial.number("body[1].volume"), 1, 1e-12);
}

TEST(Vc, OverATimeOfEvolve) {
  Trial trial("double_bubble.fe");
  trial.session().set_quiet(false);
  trial.out("refine 2; relax");
  EXPECT_TRUE(trial.out("vc 1 2 over 0.5").starts_with("body 1: target volume from 1 to 2 until time 0.5\n"));
  EXPECT_NEAR(trial.number("body[1].volume"), 1, 1e-12);
  trial.out("evolve 25 dt 0.01");
  EXPECT_NEAR(trial.number("body[1].target"), 1.5, 1e-12);
  EXPECT_NEAR(trial.number("body[1].volume"), 1.5, 1e-10);
  EXPECT_NEAR(trial.number("body[2].volume"), 1, 1e-10);
  trial.out("evolve 30 dt 0.01");
  EXPECT_EQ(trial.number("body[1].target"), 2);
  EXPECT_NEAR(trial.number("body[1].volume"), 2, 2e-11);
}

TEST(Vc, OnAndOff) {
  Trial trial("cube.fe");
  trial.session().set_quiet(false);
  trial.out("refine");
  EXPECT_EQ(trial.out("vc off"), "Volumes are free.\n");
  trial.out("g 5");
  EXPECT_LT(trial.number("body[1].volume"), 0.9);
  EXPECT_TRUE(contains(trial.failure("vc"), "test:1:1: error: volumes are free"));
  trial.out("vc 1 1.5");
  EXPECT_LT(trial.number("body[1].volume"), 0.9);
  EXPECT_EQ(trial.out("vc on"), "Volumes are kept.\n");
  trial.out("vc");
  EXPECT_NEAR(trial.number("body[1].volume"), 1.5, 1e-12);
}

TEST(Vc, TakesThePlaceOfAPressure) {
  Trial trial("cube.fe");
  trial.out("unset body[1] target; body[1].pressure := 3; vc 1 1.2");
  EXPECT_EQ(trial.number("body[1].volfixed"), 1);
  EXPECT_NEAR(trial.number("body[1].volume"), 1.2, 1e-12);
}

TEST(Vc, Refuses) {
  Trial trial("double_bubble.fe");
  const std::string before = trial.out("list vertices; v");
  EXPECT_TRUE(contains(trial.failure("vc 99 1"), "test:1:1: error: there is no body 99"));
  EXPECT_TRUE(contains(trial.failure("vc 99 1"), "bodies are numbered 1 to 2"));
  EXPECT_TRUE(contains(trial.failure("vc 1"), "a volume is missing"));
  EXPECT_TRUE(contains(trial.failure("vc 0 1"), "body must be at least 1, not 0"));
  EXPECT_TRUE(contains(trial.failure("vc 1 0"), "volume must be greater than 0, not 0"));
  EXPECT_TRUE(contains(trial.failure("vc 1 2 over 0"), "over must be greater than 0, not 0"));
  EXPECT_TRUE(contains(trial.failure("vc over 2"), "over belongs to a new target"));
  EXPECT_TRUE(contains(trial.failure("vc off 1 2"), "vc off takes nothing else"));
  EXPECT_TRUE(contains(trial.failure("vc maybe"), "vc does not take \"maybe\" here"));
  EXPECT_TRUE(contains(trial.failure("{ fix vertex; vc 1 2 }"), "cannot be brought to their targets"));
  EXPECT_EQ(trial.out("list vertices; v"), before);
  EXPECT_TRUE(contains(Trial("catenoid.fe").failure("vc"), "no body has a target volume"));
  EXPECT_TRUE(contains(Trial("catenoid.fe").failure("vc 1 2"), "this scene has no bodies"));
}

}  // namespace
}  // namespace lamella::trial
