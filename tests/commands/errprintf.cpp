#include "support/trial.h"

namespace lamella::trial {
namespace {

TEST(Errprintf, GoesToTheErrorOutput) {
  Trial trial;
  const Ran ran = trial.run("errprintf \"%d of %s\\n\", 3, \"four\"");
  EXPECT_EQ(ran.out, "");
  EXPECT_EQ(ran.messages, "3 of four\n");
}

}  // namespace
}  // namespace lamella::trial
