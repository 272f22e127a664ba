#include "support/trial.h"

namespace lamella::trial {
namespace {

TEST(Printf, WritesByTheFormat) {
  Trial trial;
  EXPECT_EQ(trial.out("printf \"%d %5.2f %s %x %c %%\\n\", 3.7, 2, \"abc\", 255, 65"),
            "3  2.00 abc ff A %\n");
  EXPECT_EQ(trial.out("printf \"no newline\"; printf \" then %g\\n\", 1/3"), "no newline then 0.333333\n");
  EXPECT_EQ(trial.out("printf \"%-5d|%+d|%05d|%*d|%.3s|%s\\n\", 1, 2, 3, 4, 5, \"abcdef\", 0.5"),
            "1    |+2|00003|   5|abc|0.5\n");
  EXPECT_EQ(trial.out("f := \"%g\\n\"; printf f, 2; name := sprintf \"out%03d\", 7; print name"),
            "2\nout007\n");
  EXPECT_EQ(trial.out("printf \"%ld %lf\\n\", 1e10, 0.5"), "10000000000 0.500000\n");
}

TEST(Printf, RefusesWhatDoesNotMatch) {
  Trial trial;
  EXPECT_TRUE(contains(trial.failure("printf \"%d\\n\""), "no value is given"));
  EXPECT_TRUE(contains(trial.failure("printf \"%d\\n\", 1, 2"), "1 value more"));
  EXPECT_TRUE(contains(trial.failure("printf \"%d\\n\", \"a\""), "takes a number"));
  EXPECT_TRUE(contains(trial.failure("printf \"%q\\n\", 1"), "is no format"));
  EXPECT_TRUE(contains(trial.failure("printf \"100%\""), "is no format"));
  EXPECT_TRUE(contains(trial.failure("printf 3"), "a string is needed"));
  EXPECT_TRUE(contains(trial.failure("printf \"%d\", 1e300"), "cannot write"));
}

}  // namespace
}  // namespace lamella::trial
