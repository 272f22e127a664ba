// What holds for every datafile of the project, whatever is in it.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>

#include "datafile/same_scene.h"
#include "energy/measure.h"
#include "energy/open_rim.h"
#include "film/check.h"
#include "support/shapes.h"
#include "support/trial.h"

namespace lamella::trial {
namespace {

namespace files = std::filesystem;

// By their paths below datafiles/.
std::vector<std::string> all_datafiles() {
  std::vector<std::string> result;
  for (const char* folder : {"", "tricky/"}) {
    for (const files::directory_entry& entry : files::directory_iterator(datafile(folder))) {
      if (entry.path().extension() == ".fe") result.push_back(folder + entry.path().filename().string());
    }
  }
  std::sort(result.begin(), result.end());
  return result;
}

class EveryDatafile : public ::testing::TestWithParam<std::string> {
 protected:
  void SetUp() override {
    // Some files have warnings, and some end with commands of Evolver that are still unknown here.
    const Ran ran = trial_.run("load \"" + datafile(GetParam()) + "\"");
    if (contains(ran.messages, "there is no command")) GTEST_SKIP() << ran.messages;
    ASSERT_EQ(ran.outcome, session::Outcome::done) << ran.messages;
    closed_ = film::check_regions(film()).empty();
  }

  const film::Film& film() { return trial_.session().scene().film; }
  energy::Measures measures() { return energy::measure(trial_.session().scene()); }

  bool held() {
    const scene::Scene& scene = trial_.session().scene();
    return !scene.level_sets.empty() || !scene.boundaries.empty() || !scene.quantities.empty();
  }

  // Runs a command and tests every invariant afterwards.
  void step(const std::string& command) {
    trial_.out(command);
    EXPECT_EQ(film::check(film()), std::vector<std::string>{}) << command;
    if (closed_) {
      EXPECT_EQ(film::check_regions(film()), std::vector<std::string>{}) << command;
    }
  }

  Trial trial_;
  bool closed_ = false;  // no body has a rim
};

void expect_same(const energy::Measures& a, const energy::Measures& b, double tolerance) {
  const double size = std::pow(a.area, 1.5);
  EXPECT_NEAR(a.area, b.area, tolerance * a.area);
  ASSERT_EQ(a.volumes.size(), b.volumes.size());
  for (std::size_t r = 1; r < a.volumes.size(); ++r)
    EXPECT_NEAR(a.volumes[r], b.volumes[r], tolerance * std::max(std::abs(a.volumes[r]), size)) << r;
}

TEST_P(EveryDatafile, KeepsItsInvariantsThroughMeshCommandsAndSaving) {
  EXPECT_EQ(film::check(film()), std::vector<std::string>{});
  const energy::Measures loaded = measures();
  const std::uint32_t facets = film().triangle_count();
  step("refine");
  EXPECT_LE(film().triangle_count(), 4 * facets);
  // New vertices on walls and curved wires are put onto them.
  if (!held()) expect_same(measures(), loaded, 1e-12);
  step("equiangulate");
  step("average");
  const Folder folder;
  const std::string saved = folder / "saved.fe";
  trial_.out("save \"" + saved + "\"");
  Trial again;
  ASSERT_EQ(again.run("load \"" + saved + "\"").outcome, session::Outcome::done);
  EXPECT_EQ(test::first_difference(trial_.session().scene(), again.session().scene()), "");
  expect_same(energy::measure(again.session().scene()), measures(), 1e-12);
  EXPECT_EQ(film::check(again.session().scene().film), std::vector<std::string>{});
  if (closed_) {
    EXPECT_EQ(film::check_regions(again.session().scene().film), std::vector<std::string>{});
  }
}

// Commands with numbers in them leave sound films too, where they can go on at all.
TEST_P(EveryDatafile, KeepsItsInvariantsThroughMotion) {
  for (const char* command : {"g 3", "evolve 3", "relax 10", "relax 5 motion full", "vc", "u 3", "V 2",
                              "refine facets where id < 4", "refine edges where id < 4", "l 0.6"}) {
    const scene::Scene before = trial_.session().scene();
    const Ran ran = trial_.run(command);
    // Films that nothing holds shrink to a point, where sheets have no order.
    std::vector<std::string> findings = film::check(film());
    std::erase_if(findings, [](const std::string& finding) { return contains(finding, "geometric order"); });
    EXPECT_EQ(findings, std::vector<std::string>{}) << command;
    if (closed_) {
      EXPECT_EQ(film::check_regions(film()), std::vector<std::string>{}) << command;
    }
    for (const film::Vec3& p : film().positions()) ASSERT_TRUE(std::isfinite(p.x + p.y + p.z)) << command;
    if (ran.outcome == session::Outcome::failed) {
      EXPECT_EQ(ran.messages.find("test:1:1: error: "), 0U) << command << ": " << ran.messages;
      EXPECT_EQ(test::first_difference(before, trial_.session().scene()), "") << command;
    }
  }
}

// Volumes belong to the bodies, not to the place where they stand.
TEST_P(EveryDatafile, VolumesDoNotDependOnThePlace) {
  if (!energy::open_rims(film()).empty()) GTEST_SKIP() << "has a body that its films do not close";
  if (held()) GTEST_SKIP() << "has walls, which do not move along";
  trial_.out("refine");
  scene::Scene scene = trial_.session().scene();
  const energy::Measures here = energy::measure(scene);
  test::move_all(scene.film, {1000, -1000, 500});
  expect_same(energy::measure(scene), here, 1e-9);
  if (!scene.film.periodic()) {  // whose periods would have to turn along
    test::rotate_all(scene.film, {1, 2, -3}, 0.7);
    expect_same(energy::measure(scene), here, 1e-9);
  }
  test::move_all(scene.film, {-1000, 1000, 1000});
  expect_same(energy::measure(scene), here, 1e-9);
}

std::string test_name(const ::testing::TestParamInfo<std::string>& info) {
  std::string name = info.param.substr(0, info.param.find('.'));
  std::replace(name.begin(), name.end(), '/', '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Datafiles, EveryDatafile, ::testing::ValuesIn(all_datafiles()), test_name);

}  // namespace
}  // namespace lamella::trial
