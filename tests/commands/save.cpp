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
