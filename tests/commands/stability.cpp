#include "support/trial.h"

namespace lamella::trial {
namespace {

// A line of the table: facets, tension, bound, largest, ratio.
std::vector<double> numbers_of(const std::string& table, const std::string& method) {
  std::istringstream in(table.substr(table.find("\n" + method) + 1 + method.size()));
  std::vector<double> numbers(5);
  for (double& number : numbers) in >> number;
  return numbers;
}

TEST(Stability, FindsTheLargestStepNearAndAboveTheBound) {
  Trial trial("cube.fe");
  trial.out("refine 2; relax");
  const std::string table = trial.out("stability methods=\"euler,verlet\" steps=200");
  for (const char* method : {"euler", "verlet"}) {
    const std::vector<double> row = numbers_of(table, method);
    EXPECT_EQ(row[0], trial.number("facet_count"));
    EXPECT_LE(row[4], 1) << table;
    EXPECT_GT(row[4], 0.75) << table;
  }
  EXPECT_EQ(trial.number("total_time"), 0);  // trials are run on copies
}

// Four times the tension, half the step.
TEST(Stability, WritesATableAndAChart) {
  Trial trial("cube.fe");
  const Folder folder;
  const std::string table = trial.out("refine; relax; stability \"" + (folder / "s.svg") +
                                      "\" methods=\"euler\" tensions=2 steps=100");
  EXPECT_TRUE(contains(file_content(folder / "s.svg"), "<svg"));
  const std::string numbers = file_content(folder / "s.csv");
  EXPECT_TRUE(numbers.starts_with("method,facets,tension,bound,largest,ratio,failure\neuler,96,1,"));
  EXPECT_TRUE(contains(numbers, "\neuler,96,4,"));
}

TEST(Stability, Refuses) {
  Trial trial("cube.fe");
  EXPECT_TRUE(
      contains(trial.failure("stability methods=\"euler,newton\""), "there is no integrator \"newton\""));
  EXPECT_TRUE(contains(trial.failure("stability \"a.gif\""), "a chart is an .svg or .png file"));
  EXPECT_TRUE(contains(Trial().failure("stability"), "there is no film to try steps on"));
}

}  // namespace
}  // namespace lamella::trial
