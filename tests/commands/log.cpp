#include "support/trial.h"

namespace lamella::trial {
namespace {

TEST(Log, WritesARowEverySoManySteps) {
  Trial trial("cube.fe");
  const Folder folder;
  EXPECT_EQ(trial.out("log"), "log off\n");
  trial.out("refine 2; relax; set vertices velocity[1] 0.1; log \"" + (folder / "m.csv") +
            "\" every 5; evolve 12");
  EXPECT_EQ(trial.out("log"), "log " + (folder / "m.csv") + " every 5\n");
  trial.out("evolve 3; log off; evolve 10");
  std::istringstream file(file_content(folder / "m.csv"));
  std::vector<std::string> lines;
  for (std::string line; std::getline(file, line);) lines.push_back(line);
  ASSERT_EQ(lines.size(), 4U);
  EXPECT_TRUE(lines[0].starts_with("time,energy,kinetic,work,balance,momentum_x"));
  double balance = 0;
  for (std::size_t row = 1; row < lines.size(); ++row) {
    std::istringstream cells(lines[row]);
    std::vector<double> values;
    for (std::string cell; std::getline(cells, cell, ',');) values.push_back(std::stod(cell));
    ASSERT_EQ(values.size(), 13U);
    if (row > 1) {
      EXPECT_NEAR(values[4], balance, 1e-3);
    }
    balance = values[4];
    EXPECT_LT(values[11], 1e-11);
  }
}

TEST(Log, Refuses) {
  Trial trial("cube.fe");
  EXPECT_TRUE(contains(trial.failure("log /no/such/folder/a.csv"), "/no/such/folder"));
  EXPECT_TRUE(contains(trial.failure("log a.csv every 0"), "at least 1"));
}

TEST(Log, EventsHaveATableOfTheirOwn) {
  const Folder folder;
  Trial trial("double_bubble.fe");
  trial.out("log events \"" + folder / "events.csv" + "\"; burst facet[1]; log events off; burst body[1]");
  const std::string table = file_content(folder / "events.csv");
  EXPECT_EQ(table.substr(0, table.find('\n')), "time,event,x,y,z,bodies");
  EXPECT_TRUE(contains(table, "0,burst,"));
  EXPECT_TRUE(contains(table, ",1 2\n"));
  EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 2);
}

}  // namespace
}  // namespace lamella::trial
