#include "support/trial.h"

namespace lamella::trial {
namespace {

TEST(TinyFacets, CollapsesWhatIsSmaller) {
  Trial trial("double_bubble.fe");
  trial.session().set_quiet(false);
  trial.out("r; r; set vertex x x*(1+0.3*y+0.1*z*z)");
  EXPECT_EQ(trial.out("w 1e-6"), "Skinny triangles weeded: 0\n");
  const std::string told = trial.out("w 0.008");
  EXPECT_EQ(told, fmt::format("Skinny triangles weeded: {}\n", trial.number("facet_delete_count")));
  EXPECT_GT(trial.number("facet_delete_count"), 10);
  EXPECT_EQ(trial.out("check"), "Checks completed.\n");
}

TEST(TinyFacets, Refuses) {
  EXPECT_TRUE(contains(Trial("cube.fe").failure("w"), "w needs area"));
  EXPECT_TRUE(contains(Trial().failure("areaweed 1"), "there is no film to weed"));
}

}  // namespace
}  // namespace lamella::trial
