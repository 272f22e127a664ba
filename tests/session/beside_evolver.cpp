// The same commands here and in Surface Evolver: the same elements, and the same energies at equilibrium.
#include <cmath>
#include <filesystem>
#include <set>
#include <sstream>

#include "support/evolver.h"
#include "support/trial.h"

namespace lamella::trial {
namespace {

bool has_peer(const std::string& example) {
  return evolver_is_installed() && std::filesystem::exists(evolver_example(example));
}

// The lines of `list edges` and `list facets`: a number and two or three others, without what follows them.
std::multiset<std::string> elements_in(const std::string& listing) {
  std::multiset<std::string> rows;
  std::istringstream lines(listing);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string row;
    int numbers = 0;
    for (int n = 0; numbers < 4 && words >> n; ++numbers) row += fmt::format(" {}", n);
    if (numbers >= 3 && line.find('.') > line.find("/*")) rows.insert(row);
  }
  return rows;
}

struct Case {
  const char* file;
  const char* commands;  // separated by semicolons
};

std::string one_a_line(std::string commands) {
  for (char& c : commands)
    if (c == ';') c = '\n';
  return commands;
}

class SameElements : public ::testing::TestWithParam<Case> {};

TEST_P(SameElements, AsInEvolver) {
  const auto [file, commands] = GetParam();
  if (!has_peer(file)) GTEST_SKIP() << "needs Surface Evolver and its examples";
  const std::string list = "list edges;list facets";
  const auto theirs =
      elements_in(evolver_output(evolver_example(file), one_a_line(std::string(commands) + ";" + list)));
  Trial trial;
  trial.session().load(evolver_example(file));
  trial.run(commands);
  const auto ours = elements_in(trial.out(list));
  EXPECT_GT(ours.size(), 10U);
  EXPECT_EQ(ours, theirs);
}

INSTANTIATE_TEST_SUITE_P(
    Meshes, SameElements,
    ::testing::Values(Case{"quad", "r;r"}, Case{"quad", "refine edges"}, Case{"quad", "refine facets;u"},
                      Case{"quad", "r;set vertex z z+x*y;refine edge where id % 3 == 1;u;w .03;t .2"},
                      Case{"cube", "set vertex x x+y*.7;u"}, Case{"cube", "r;set vertex x x+z*.7+y;u;u;l .6"},
                      Case{"cube", "g 3;r;edgeswap edge where id % 7 == 3;r"}, Case{"column", "u;r;u"},
                      Case{"mound", "re;edgeswap edge where id % 5 == 2"},
                      Case{"octa", "r;set vertex x x+z*.7+y;u"}));

// Each file's own script, then what brings both programs to the same equilibrium: where a script ends in
// rounding (at a film that no step lowers any more) the ways part, and only the end can agree.
class SameEnergy : public ::testing::TestWithParam<Case> {};

TEST_P(SameEnergy, AfterItsOwnScript) {
  const auto [file, commands] = GetParam();
  if (!has_peer(file)) GTEST_SKIP() << "needs Surface Evolver and its examples";
  const std::string all = std::string("gogo;") + commands;
  const double theirs = evolver_number(evolver_example(file), one_a_line(all), "total_energy");
  Trial trial;
  trial.session().load(evolver_example(file));
  trial.run(all);
  EXPECT_NEAR(trial.number("total_energy"), theirs, 1e-9 * std::abs(theirs));
}

constexpr const char* to_the_end =
    "hessian_normal off;conj_grad on;g 300;conj_grad off;g 50;{hessian_seek} 10;{hessian} 4";

INSTANTIATE_TEST_SUITE_P(Examples, SameEnergy,
                         ::testing::Values(Case{"cube", "hessian_normal off;{hessian_seek} 10;{hessian} 4"},
                                           Case{"quad", "{hessian} 4"}, Case{"mound", to_the_end},
                                           Case{"qmound", to_the_end}, Case{"catbody", "{hessian} 4"},
                                           Case{"catman", to_the_end}, Case{"twointor", "{hessian} 2"},
                                           Case{"phelanc", "{hessian} 2"}, Case{"slidestr", to_the_end},
                                           Case{"octa", "{hessian} 4"}),
                         [](const auto& row) { return std::string(row.param.file); });

// What becomes of a film in another cell.
TEST(AFlatFoam, IsShearedAsInEvolver) {
  if (!evolver_is_installed()) GTEST_SKIP() << "needs Surface Evolver";
  const std::string scene = datafile("flat_foam.fe");
  for (const char* commands : {"shear := 0.3", "shear := 0.3;recalc;{g 100} 20"}) {
    Trial trial("flat_foam.fe");
    trial.out(commands);
    EXPECT_NEAR(trial.number("total_length"), evolver_number(scene, one_a_line(commands), "total_length"),
                1e-9)
        << commands;
  }
}

}  // namespace
}  // namespace lamella::trial
