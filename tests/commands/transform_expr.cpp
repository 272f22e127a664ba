#include "support/trial.h"

namespace lamella::trial {
namespace {

TEST(TransformExpr, IsKept) {
  Trial trial("cube.fe");
  EXPECT_EQ(trial.number("transforms"), 0);
  trial.out("transform_expr \"3(a|b)\"");
  EXPECT_EQ(trial.out("print transform_expr"), "3(a|b)\n");
  EXPECT_EQ(trial.number("transforms"), 1);
  trial.out("transforms off");
  const Folder folder;
  trial.out("transforms on; save \"" + (folder / "kept.fe") + "\"");
  const std::string saved = file_content(folder / "kept.fe");
  EXPECT_TRUE(contains(saved, "transform_expr \"3(a|b)\"\ntransforms on\n")) << saved;
}

}  // namespace
}  // namespace lamella::trial
