#include "support/trial.h"

namespace lamella::trial {
namespace {

TEST(Chart, WritesATableAndAPicture) {
  const Folder folder;
  Trial trial("cube.fe");
  trial.session().set_quiet(false);
  const std::string told = trial.out("chart \"" + (folder / "race.svg") +
                                     "\" levels=2 methods=\"relax,lbfgs,cg\" exact=4.835975862049");
  EXPECT_TRUE(contains(told, "\nrelax  "));
  EXPECT_TRUE(contains(told, "\ncg  "));
  const std::string table = file_content(folder / "race.csv");
  EXPECT_TRUE(table.starts_with("method,seconds,facets,energy,error\n"));
  EXPECT_TRUE(contains(table, "\nlbfgs,"));
  EXPECT_TRUE(contains(file_content(folder / "race.svg"), "<svg"));
  EXPECT_EQ(trial.number("facet_count"), 24);  // races are run on copies
}

TEST(Chart, Refuses) {
  Trial trial("cube.fe");
  EXPECT_TRUE(contains(trial.failure("chart methods=\"relax,euler\""), "there is no method \"euler\""));
  EXPECT_TRUE(contains(trial.failure("chart \"race.gif\""), "a chart is an .svg or .png file"));
  EXPECT_TRUE(contains(Trial().failure("chart"), "there is no film to race on"));
}

}  // namespace
}  // namespace lamella::trial
