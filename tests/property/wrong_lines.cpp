// Lines that are wrong, each in its way: every one ends with an error that has a place, and the scene is as
// it was, bit for bit.
#include <regex>

#include "datafile/same_scene.h"
#include "datafile/write.h"
#include "support/trial.h"

namespace lamella::trial {
namespace {

constexpr const char* wrong_lines[] = {
    "average x",
    "average -1",
    "average 1.5",
    "average 1e30",
    "V 2 3",
    "check 1",
    "C all",
    "counts 1",
    "c x",
    "equiangulate -1",
    R"(u "a")",
    "u 0.5",
    "evolve -1",
    "evolve dt",
    "evolve 10 dt 0",
    "evolve 10 dt -1",
    "evolve dt nan",
    "evolve dt inf",
    "evolve 1 dt 1/0",
    "evolve 1.5",
    "evolve 1e300",
    "evolve 1 2",
    "evolve step 1",
    R"(evolve "a")",
    "evolve {",
    "evolve 1 dt auto dt 1",
    R"(evolve 1 dt "a")",
    "evolve dt 0.1 dt 0.2",
    "evolve 1 ddt 0.1",
    "fix_scale 0",
    "m -1",
    "m 1e400",
    "m x",
    "g -1",
    "g 1.5",
    "g x",
    "g 1 2",
    "g 1e20",
    "g {",
    "l",
    "l -1",
    "l x",
    "l 1 2",
    R"(l "a")",
    "l 1e400",
    "long_edges nan",
    "plateau 1",
    "plateau x",
    "refine 1e9",
    "refine -1",
    "refine 21",
    "refine 0.5",
    "refine vertex",
    "refine vertices where x > 0",
    "refine body[1]",
    "refine edges where",
    "refine edges where lenght > 1",
    "refine edge[0]",
    "refine 2 3",
    "refine edge ee where ee.nothing > 1",
    "relax -1",
    "relax tolerance 0",
    "relax tolerance -1",
    "relax tolerance nan",
    "relax tolerance",
    "relax method",
    "relax method newtn",
    "relax method 3",
    "relax motion sideways",
    "relax motion",
    "relax 1 2",
    "relax keepmesh",
    "relax 1e300",
    "report 1",
    "i x",
    "vc 99 1",
    "vc 0 1",
    "vc -1 1",
    "vc 1",
    "vc 1 -1",
    "vc 1 0",
    "vc 1 nan",
    "vc 1 1e400",
    "vc 1.5 1",
    "vc 1 2 3",
    "vc 1 2 over",
    "vc 1 2 over 0",
    "vc 1 2 over -1",
    "vc over 3",
    "vc maybe",
    "vc on off",
    "vc on 1 2",
    R"(vc "1" 2)",
    "vc 1 2 ober 3",
    "vc 1 1e300",
    "volumes 1",
    "v x",
    R"(show "x.png" size=0x0)",
    "g 5 }",
    "{ g 5",
    "{ evolve 1; refine",
    "if 1 then",
    "( refine",
    "refnie",
    "evolve,",
    "refine edges where 1/0 > 1",
    "refine edge[999999]",
    "{ refine 2; g -1 }",
    "{ g 1; l -1 }",
    "{ evolve 3; vc 99 1 }",
    "refine 20",
    "evolve 1 dt 1e300",
    "evolve 1 dt 1e-300",
    "vc 1 1e-300",
    "vc 1 2 over nan",
    "refine 2 edges where id < 3",
    "relax method descent motion full",
    "{ fix vertex; vc 1 2 }",
    "{ vc 1 2; V -1 }",
    "{ x := 1; set vertex x 5; evolve dt -1 }",
    "for (i := 0; i < 3; i++) { g 1; refine -1 }",
    "show a.png width 0",
    "show a.png height -5",
    "undo -1",
    "{ refine; nonsense := nothing }",
    "print 1/0",
    "evolve sqrt(-1)",
    "g acos(2)",
    "l 0/0",
    "refine 1e300*1e300",
    "evolve dt 1e308*10",
    "vc body[7].target 1",
    "vc 1 body[9].volume",
    "fix_scale 1/0",
    "relax tolerance 1e-400*0",
};

// Wrong where there is no film, and right elsewhere.
constexpr const char* lines_for_a_film[] = {
    "average",
    "V 3",
    "u",
    "equiangulate 2",
    "evolve",
    "evolve 10 dt 0.01",
    "g",
    "g 5",
    "l 0.1",
    "refine",
    "r 2",
    "relax",
    "relax method descent",
    "relax 1",
    "vc",
    "vc 1 2",
    "vc 1 2 over 1",
    "refine edges",
    "refine facet[1]",
    "show",
    "show \"none.png\"",
};

// What is wrong leaves no trace.
void expect_refused(Trial& trial, const std::string& line) {
  static const std::regex place("test:[0-9]+:[0-9]+: error: ");
  const scene::Scene before = trial.session().scene();
  const std::string saved = datafile::write_datafile(before);
  const Ran ran = trial.run(line);
  EXPECT_EQ(ran.outcome, session::Outcome::failed) << line;
  EXPECT_TRUE(std::regex_search(ran.messages, place, std::regex_constants::match_continuous)) << line << "\n"
                                                                                              << ran.messages;
  EXPECT_EQ(ran.messages.find("internal fault"), std::string::npos) << line;
  EXPECT_EQ(test::first_difference(before, trial.session().scene()), "") << line;
  EXPECT_EQ(datafile::write_datafile(trial.session().scene()), saved) << line;
}

TEST(WrongLines, AreRefusedAndLeaveNoTrace) {
  Trial trial("double_bubble.fe");
  trial.out("refine; evolve 2; vc 1 1.5 over 3; define vertex attribute heat real; set vertex heat x");
  for (const char* line : wrong_lines) expect_refused(trial, line);
  trial.out("check; relax; undo; evolve 3");
}

TEST(WrongLines, AreRefusedOnAnEmptyScene) {
  Trial trial;
  for (const char* line : wrong_lines) expect_refused(trial, line);
  for (const char* line : lines_for_a_film) expect_refused(trial, line);
  EXPECT_FALSE(std::filesystem::exists("none.png"));
}

// A line cut anywhere is wrong or right, but never more than that.
TEST(WrongLines, CutAnywhere) {
  const std::string line =
      "refine edges where length > 0.3; relax 3 motion full tolerance=1e-3; vc 1 2 over 0.5; "
      "evolve 2 dt 0.01; { g 1; u } 2; V; plateau; report";
  for (std::size_t length = 1; length < line.size(); ++length) {
    Trial trial("cube.fe");
    const Ran ran = trial.run(line.substr(0, length));
    EXPECT_EQ(ran.messages.empty(), ran.outcome == session::Outcome::done) << line.substr(0, length);
    trial.out("check");
  }
}

}  // namespace
}  // namespace lamella::trial
