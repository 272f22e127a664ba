#include "support/trial.h"

namespace lamella::trial {
namespace {

TEST(Save, WritesWhatLoadReadsBack) {
  Trial trial("double_bubble.fe");
  const Folder folder;
  const std::string file = folder / "saved.fe";
  trial.out("refine; set facet color red where id < 9; x := 0.1; mygo := { print x }; save \"" + file + "\"");
  Trial other;
  EXPECT_EQ(other.out("load " + file + "; mygo"), "0.1\n");
  for (const char* value :
       {"vertex_count", "total_area", "body[2].volume", "count(facet where color == red)"}) {
    EXPECT_NEAR(other.number(value), trial.number(value), 1e-13) << value;
  }
}

// That a run which is saved after `start` and goes on from the file has the values of the whole one.
void expect_checkpoint(Trial& whole, const char* scene, const std::string& start, const std::string& go_on,
                       std::initializer_list<const char*> values) {
  Trial saved(scene);
  const Folder folder;
  saved.out(start + "; save \"" + (folder / "half.fe") + "\"");
  Trial continued;
  continued.out("load \"" + (folder / "half.fe") + "\"; " + go_on);
  for (const char* value : values) EXPECT_EQ(continued.number(value), whole.number(value)) << value;
}

// A run continued from a file is the run that went on, to the last bit.
TEST(Save, IsACheckpointOfAMovingFilm) {
  const std::string start =
      "refine 3; relax; damping := 0.1; force (0, 0, -0.3*sin(3*total_time)); kick (0.2*z, 0.1*x^2, 0)"
      "; vc 1 1.3 over 0.4; evolve 40 keep_mesh";
  Trial whole("double_bubble.fe");
  whole.out(start + "; evolve 60 keep_mesh; print outer_work");
  expect_checkpoint(whole, "double_bubble.fe", start, "evolve 60 keep_mesh",
                    {"total_time", "total_energy", "kinetic_energy", "outer_work", "body[1].pressure",
                     "sum(vertices, x*id)", "sum(vertices, y*id)", "sum(vertices, velocity[3]*id)"});
}

// Also where the mesh is made fit on the way, after the file was written.
TEST(Save, IsACheckpointOfAMeshInMotion) {
  const std::string start = "refine 2; relax; kick (0.5*z, 0.3*x^2, 0); evolve 150";
  Trial whole("double_bubble.fe");
  whole.out(start + "; evolve 40");
  expect_checkpoint(whole, "double_bubble.fe", start, "evolve 40",
                    {"total_time", "total_energy", "kinetic_energy", "sum(vertices, x*id)",
                     "sum(vertices, velocity[3]*id)", "sum(edges, id*length)"});
}

// And where films change their topology.
TEST(Save, IsACheckpointOfFilmsThatMerge) {
  const std::string start = "topology on; throw; evolve 8";
  Trial whole("two_bubbles.fe");
  whole.out(start + "; merges := 0; on merge { merges += 1 }; evolve 60");
  ASSERT_EQ(whole.number("merges"), 1);
  expect_checkpoint(whole, "two_bubbles.fe", start, "topology on; evolve 60",
                    {"total_time", "total_energy", "kinetic_energy", "facet_count", "sum(vertices, x*id)",
                     "sum(vertices, velocity[3]*id)", "sum(edges, id*length)"});
}

TEST(Save, HasAliasesAndADefault) {
  Trial trial("cube.fe");
  const Folder folder;
  const std::filesystem::path before = std::filesystem::current_path();
  std::filesystem::current_path(folder / ".");
  trial.out("save; d other.fe; dump \"third.fe\"");
  std::filesystem::current_path(before);
  for (const char* name : {"cube.dmp", "other.fe", "third.fe"})
    EXPECT_TRUE(std::filesystem::exists(folder / name)) << name;
  EXPECT_TRUE(
      contains(trial.failure("save \"" + (folder / "none/a.fe") + "\""), "test:1:6: error: cannot write"));
}

}  // namespace
}  // namespace lamella::trial
