#include "support/trial.h"

namespace lamella::trial {
namespace {

TEST(RenumberAll, CountsFromOne) {
  Trial trial("cube.fe");
  trial.out("r; t 0.36");
  EXPECT_GT(trial.number("max(vertex, id)"), trial.number("vertex_count"));
  trial.out("renumber_all");
  EXPECT_EQ(trial.number("max(vertex, id)"), trial.number("vertex_count"));
  EXPECT_EQ(trial.number("max(facet, id)"), trial.number("facet_count"));
}

}  // namespace
}  // namespace lamella::trial
