// The scripts of datafiles/motion: each runs, a few steps of it, so that none rots; and what some come to.
#include <filesystem>
#include <regex>

#include "support/trial.h"

namespace lamella::trial {
namespace {

namespace files = std::filesystem;

struct Script {
  std::string name;
  std::string scene;  // from its first line: `// On NAME.fe: ...`
  std::string text;
};

std::vector<Script> scripts() {
  std::vector<Script> found;
  for (const auto& entry : files::directory_iterator(datafile("motion"))) {
    if (entry.path().extension() != ".cmd") continue;
    const std::string text = file_content(entry.path().string());
    std::smatch match;
    EXPECT_TRUE(std::regex_search(text, match, std::regex("^// On ([a-z_]+\\.fe)"))) << entry.path();
    found.push_back({entry.path().filename().string(), match.str(1), text});
  }
  std::sort(found.begin(), found.end(), [](const Script& a, const Script& b) { return a.name < b.name; });
  return found;
}

// Few steps on a coarse mesh, and nothing written.
std::string shortened(std::string text) {
  const std::pair<const char*, const char*> changes[] = {
      {"evolve [0-9]+", "evolve 4"},       {"refine [0-9]", "refine 1"}, {"borders 0.[0-9]+", "borders 0.3"},
      {"air cells [0-9]+", "air cells 8"}, {"log \"[^\n]*", ""},         {"log off", ""}};
  for (const auto& [from, to] : changes) text = std::regex_replace(text, std::regex(from), to);
  return text;
}

TEST(MotionScripts, AllRun) {
  const std::vector<Script> all = scripts();
  EXPECT_GE(all.size(), 13U);
  for (const Script& script : all) {
    SCOPED_TRACE(script.name);
    Trial trial(script.scene);
    const Ran ran = trial.run(shortened(script.text));
    EXPECT_EQ(ran.outcome, session::Outcome::done) << ran.messages;
    EXPECT_EQ(trial.run("check").outcome, session::Outcome::done);
  }
}

// On a coarse mesh, along borders too.
std::string script(const std::string& name, const std::string& refinement) {
  const std::string text = file_content(datafile("motion/" + name));
  return std::regex_replace(std::regex_replace(text, std::regex("refine [0-9]"), refinement),
                            std::regex("borders 0.[0-9]+"), "borders 0.3");
}

// Rows of cells glide past one another by swapping neighbours. When, and which, depends on rounding.
TEST(MotionScripts, AFlatFoamThatIsShearedFlows) {
  Trial trial("flat_foam.fe");
  EXPECT_NEAR(trial.number("total_length"), 10.19708695214, 1e-11);
  trial.out(file_content(datafile("motion/flat_shear.cmd")));
  EXPECT_GT(trial.number("swaps"), 5);
  EXPECT_EQ(trial.number("facet_count"), 30);
  EXPECT_NEAR(trial.number("sum(body bb, bb.volume)"), 1, 1e-12);
  EXPECT_NEAR(trial.number("max(body bb, abs(bb.volume - bb.target))"), 0, 1e-4);
  EXPECT_LT(trial.number("total_length"), 11);  // 14.4 had they kept their neighbours
}

// Two spheres are left, inscribed in which the meshes have a little less volume for their area.
TEST(MotionScripts, AFilmBetweenBubblesThatArePulledApartIsGone) {
  Trial trial("double_bubble.fe");
  EXPECT_EQ(trial.run(script("pull_apart.cmd", "refine 2")).outcome, session::Outcome::done);
  EXPECT_EQ(trial.number("body_count"), 2);
  EXPECT_EQ(trial.number("count(facet where frontbody != 0 and backbody != 0)"), 0);
  EXPECT_GT(trial.number("total_area"), 9.671952);
  EXPECT_LT(trial.number("total_area"), 9.72);
}

TEST(MotionScripts, AFoamBurstsToTheLastBubble) {
  Trial trial("six_bubbles.fe");
  const Ran ran = trial.run(script("burst_foam.cmd", "refine 1"));
  EXPECT_EQ(ran.outcome, session::Outcome::done) << ran.messages;
  EXPECT_EQ(trial.number("facet_count"), 0);
}

TEST(MotionScripts, FourBubblesFallOntoAFilm) {
  Trial trial("four_falling.fe");
  const Ran ran = trial.run(script("four_falling.cmd", "refine 1"));
  EXPECT_EQ(ran.outcome, session::Outcome::done) << ran.messages;
  EXPECT_EQ(trial.number("body_count"), 4);
  EXPECT_NEAR(trial.number("max(vertices, z) + min(vertices, z)"), 0, 0.1)
      << "lenses, half above, half below";
  EXPECT_LT(trial.number("kinetic_energy"), 0.01);
}

// The film between two of them shrinks, and the other two meet. How far that has come in so many steps
// depends on rounding: what is left of the old film may make steps short.
TEST(MotionScripts, FourBubblesThatAreShearedMeetOtherNeighbours) {
  Trial trial("four_bubbles.fe");
  const auto shared = [&](int a, int b) {
    const std::string one = std::to_string(a);
    const std::string other = std::to_string(b);
    return trial.number("count(facet where frontbody == " + one + " and backbody == " + other +
                        " or frontbody == " + other + " and backbody == " + one + ")");
  };
  trial.run("topology on; refine 2; damping := 3; evolve 160");
  EXPECT_EQ(shared(1, 4), 0);
  const double before = shared(2, 3);
  EXPECT_GT(before, 10);
  EXPECT_GT(trial.number("total_time"), 4);
  trial.run("kick (-y, -x, 0); damping := 1; evolve 90; damping := 4; evolve 200");
  EXPECT_GT(shared(1, 4), 0);
  EXPECT_LT(shared(2, 3), before);
  EXPECT_EQ(trial.run("check").outcome, session::Outcome::done);
}

}  // namespace
}  // namespace lamella::trial
