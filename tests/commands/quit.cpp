#include "support/trial.h"

namespace lamella::trial {
namespace {

TEST(Quit, EndsTheRunFromWithinAnything) {
  for (const char* text : {"print 1; quit; print 2", "print 1\nq\nprint 2", "{ print 1; q; print 2 } 3",
                           "go := { print 1; bye }; go; print 2", "while 1 do { print 1; exit }"}) {
    Trial trial;
    const Ran ran = trial.run(text);
    EXPECT_EQ(ran.out, "1\n") << text;
    EXPECT_EQ(ran.outcome, session::Outcome::quit) << text;
    EXPECT_EQ(ran.messages, "") << text;
  }
}

}  // namespace
}  // namespace lamella::trial
