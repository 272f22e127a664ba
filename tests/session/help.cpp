#include "session/help.h"

#include "session/progress.h"
#include "support/trial.h"

namespace lamella::trial {
namespace {

TEST(Help, ListsEveryCommandOnce) {
  Trial trial;
  const std::string overview = trial.out("help");
  for (const session::Command* const command : session::command_table()) {
    EXPECT_TRUE(contains(overview, "\n  " + command->name)) << command->name;
    EXPECT_TRUE(contains(overview, command->summary)) << command->name;
  }
}

TEST(Help, TellsOfEveryCommandAndAlias) {
  Trial trial;
  for (const session::Command* const command : session::command_table()) {
    const std::string page = trial.out("help " + command->name);
    EXPECT_TRUE(contains(page, command->name));
    for (const std::string& alias : command->aliases) EXPECT_EQ(trial.out("help " + alias), page) << alias;
  }
}

TEST(Help, TellsOfOtherNames) {
  Trial trial("cube.fe");
  EXPECT_TRUE(contains(trial.out("help sqrt"), "square root"));
  EXPECT_TRUE(contains(trial.out("help total_area"), "area of all facets"));
  EXPECT_TRUE(contains(trial.out("help length"), "edge[...].length"));
  EXPECT_TRUE(contains(trial.out("help edge_length"), "a variable, now 1"));
  EXPECT_TRUE(contains(trial.out("help red"), "4"));
  EXPECT_TRUE(contains(trial.out("help foreach"), "foreach"));
  EXPECT_TRUE(contains(trial.failure("help refnie"), "did you mean \"refine\"?"));
}

TEST(Readable, StripsMarksAndSetsTables) {
  EXPECT_EQ(session::readable("# `refine`\n\nSee [undo](undo.md) and **stop**.\n\n```\nrefine 2\n```\n\n"
                              "| option | meaning |\n|---|---|\n| `dt` | step |\n| `n` | how often |\n",
                              false),
            "refine\n\nSee undo and stop.\n\n    refine 2\n\n  option  meaning\n  dt      step\n  n       "
            "how often\n");
}

TEST(Progress, SaysHowFarAndHowLong) {
  EXPECT_EQ(session::progress_line(12, 500, 31.25, 9.139420001),
            "12 of 500 steps, 31.2 steps/s, 16 s left, energy 9.13942");
  EXPECT_EQ(session::progress_line(12, 0, 0, 1), "12 steps, energy 1");
  EXPECT_EQ(session::progress_line(1, 10000, 1, 1), "1 of 10000 steps, 1 steps/s, 2 h 46 min left, energy 1");
}

}  // namespace
}  // namespace lamella::trial
