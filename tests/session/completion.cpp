#include "session/completion.h"

#include <algorithm>

#include "support/trial.h"

namespace lamella::trial {
namespace {

struct Case {
  const char* line;
  std::vector<std::string> offered;  // among others
  std::vector<std::string> not_offered;
};

TEST(Completion, OffersWhatFits) {
  Trial trial("cube.fe");
  trial.out("gogo := { print 1 }; gone := 3");
  const Case cases[] = {
      {"pri", {"print", "printf"}, {"procedure"}},
      {"go", {"gogo", "gone", "go"}, {}},
      {"x := 3; ref", {"refine"}, {}},
      {"{ ref", {"refine"}, {}},
      {"print total_a", {"total_area"}, {"total_time"}},
      {"print TOTAL_A", {"total_area"}, {}},
      {"print gon", {"gone"}, {}},
      {"print sq", {"sqr", "sqrt"}, {}},
      {"print vertex[1].", {"x", "id", "edge"}, {"length", "volume"}},
      {"print edge[2].le", {"length"}, {}},
      {"foreach facet ff do print ff.ar", {"area"}, {}},
      {"print facet[1].edge[2].len", {"length"}, {}},
      {"evolve ", {"dt"}, {"total_area"}},
      {"evolve 5 dt au", {"auto"}, {"area"}},
      {"list vert", {"vertex", "vertices"}, {}},
      {"list edges where len", {"length"}, {}},
      {"set facet co", {"color"}, {"count"}},
      {"list pro", {"procedures"}, {}},
      {"help equi", {"equiangulate"}, {}},
      {"foreach vertex vv wh", {"where"}, {}},
  };
  for (const Case& each : cases) {
    const session::Completion completion = session::complete(trial.session(), each.line);
    const auto offers = [&](const std::string& word) {
      return std::find(completion.candidates.begin(), completion.candidates.end(), word) !=
             completion.candidates.end();
    };
    for (const std::string& word : each.offered)
      EXPECT_TRUE(offers(word)) << each.line << " should offer " << word;
    for (const std::string& word : each.not_offered)
      EXPECT_FALSE(offers(word)) << each.line << " should not offer " << word;
  }
}

TEST(Completion, OffersFilesWhereAFileIsExpected) {
  Trial trial("cube.fe");
  EXPECT_TRUE(session::complete(trial.session(), "load ").files);
  EXPECT_TRUE(session::complete(trial.session(), "show ../pict").files);
  EXPECT_TRUE(session::complete(trial.session(), "read \"scr").files);
  EXPECT_FALSE(session::complete(trial.session(), "print tot").files);
}

TEST(Completion, NeverFails) {
  Trial trial;
  for (const char* line :
       {"", " ", ".", "].", "[", "\"", "{{{", "vertex[", "foreach", "a.b.c.", "; ;", "print \"a", "\xff"}) {
    session::complete(trial.session(), line);
  }
}

}  // namespace
}  // namespace lamella::trial
