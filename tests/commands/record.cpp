#include "support/trial.h"

namespace lamella::trial {
namespace {

std::vector<std::string> files_in(const Folder& folder) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder / "."))
    names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

std::vector<double> times_of(const std::string& pvd) {
  std::vector<double> times;
  for (std::size_t at = pvd.find("timestep=\""); at != std::string::npos;
       at = pvd.find("timestep=\"", at + 1))
    times.push_back(std::stod(pvd.substr(at + 10)));
  return times;
}

TEST(Record, FramesComeAtEvenTimes) {
  Trial trial("double_bubble.fe");
  const Folder folder;
  trial.out("vc 1 0.5; record \"" + (folder / "a.pvd") + "\" fps=50 speed=2 { evolve 40 }");
  const std::vector<double> times = times_of(file_content(folder / "a.pvd"));
  const double last = trial.number("total_time");
  ASSERT_GT(times.size(), 5U);
  EXPECT_EQ(times.size(), static_cast<std::size_t>(last / 0.04 + 1e-6) + 1);
  for (std::size_t i = 0; i < times.size(); ++i) EXPECT_NEAR(times[i], 0.04 * static_cast<double>(i), 1e-12);
  EXPECT_EQ(files_in(folder).size(), times.size() + 1);
}

TEST(Record, StepsAreCountedWhereNoTimePasses) {
  Trial trial("cube.fe");
  const Folder folder;
  trial.out("refine; record \"" + (folder / "a-%02d.png") + "\" size=24x18 every=4 { g 10 }");
  EXPECT_EQ(files_in(folder), (std::vector<std::string>{"a-00.png", "a-01.png", "a-02.png"}));
  trial.out("record \"" + (folder / "b.png") + "\" size=24x18 every=1 { g 2 }");
  EXPECT_TRUE(std::filesystem::exists(folder / "b-0002.png"));
  const Ran still = trial.run("record \"" + (folder / "c.png") + "\" size=24x18 { g 2 }");
  EXPECT_TRUE(contains(still.messages, "every=1 takes each step"));
  EXPECT_FALSE(std::filesystem::exists(folder / "c-0001.png"));
  EXPECT_NE(file_content(folder / "a-00.png"), file_content(folder / "a-02.png"));
}

TEST(Record, APagePlaysTheFrames) {
  Trial trial("cube.fe");
  const Folder folder;
  trial.out("refine 2; g 20; record \"" + (folder / "a.html") + "\" fps=12 every=1 color=vertex z { g 3 }");
  const std::string page = file_content(folder / "a.html");
  EXPECT_TRUE(contains(page, "const rate = 12;"));
  EXPECT_TRUE(contains(page, "<div>z</div>"));
  int frames = 0;
  for (std::size_t at = page.find("{time:"); at != std::string::npos; at = page.find("{time:", at + 1))
    ++frames;
  EXPECT_EQ(frames, 4);
  // The mesh stays as it is, and is written once.
  EXPECT_EQ(page.find(",triangles:\""), page.rfind(",triangles:\""));
}

TEST(Record, Videos) {
  if (std::system("ffmpeg -version >/dev/null 2>&1") != 0) GTEST_SKIP() << "ffmpeg is not installed";
  Trial trial("cube.fe");
  const Folder folder;
  trial.out("record \"" + (folder / "a.mp4") + "\" size=33x25 every=1 { g 3 }");
  EXPECT_TRUE(contains(file_content(folder / "a.mp4").substr(0, 12), "ftyp"));
  trial.out("record \"" + (folder / "a.gif") + "\" size=32x24 fps=10 every=1 { g 3 }");
  EXPECT_TRUE(file_content(folder / "a.gif").starts_with("GIF89a"));
  EXPECT_EQ(files_in(folder), (std::vector<std::string>{"a.gif", "a.mp4"}));
}

TEST(Record, WhatFailsLeavesNothing) {
  Trial trial("cube.fe");
  const Folder folder;
  for (const char* name : {"a.mp4", "a.png", "a.html", "a.pvd"}) {
    trial.failure("record \"" + (folder / name) + "\" size=24x18 { g 2; print 1/0 }");
    EXPECT_TRUE(files_in(folder).empty()) << name;
  }
  EXPECT_EQ(trial.number("total_area"), 6);
  trial.out("g");  // nobody follows any more
  EXPECT_TRUE(files_in(folder).empty());
}

TEST(Record, Refuses) {
  Trial trial;
  EXPECT_TRUE(contains(trial.failure("record a.mp4 { g }"), "nothing to record"));
  trial.session().load(datafile("cube.fe"));
  EXPECT_TRUE(contains(trial.failure("record a.avi2 { g }"), "\".avi2\""));
  EXPECT_TRUE(contains(trial.failure("record a.mp4"), "needs commands"));
  EXPECT_TRUE(contains(trial.failure("record a.mp4 fps=0 { g }"), "greater than 0"));
  EXPECT_TRUE(contains(trial.failure("record \"a%s.png\" { g }"), "frame-%04d.png"));
  EXPECT_TRUE(contains(trial.failure("record /no/such/folder/a.png { g }"), "/no/such/folder/a.png"));
}

}  // namespace
}  // namespace lamella::trial
