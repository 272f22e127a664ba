#include "support/trial.h"

namespace lamella::trial {
namespace {

TEST(Arrays, HoldNumbers) {
  Trial trial;
  trial.out("define aa real[3][4]; aa[2][3] := 4.5; aa[2][3] += 2");
  EXPECT_EQ(trial.out("print aa[2][3]"), "6.5\n");
  EXPECT_EQ(trial.out("print aa[2]"), "{0, 0, 6.5, 0}\n");
  EXPECT_EQ(trial.out("print aa"), "{{0, 0, 0, 0},\n {0, 0, 6.5, 0},\n {0, 0, 0, 0}}\n");
  EXPECT_EQ(trial.out("print sizeof(aa); print aa[2][3] + aa[1][1]*2"), "12\n6.5\n");
  EXPECT_EQ(trial.out("aa := 3; aa[1] := 7; print aa[1][4] + aa[3][4]"), "10\n");
  EXPECT_EQ(trial.out("define bb real[4]; bb := aa[1]; bb[2] := 0; print bb"), "{7, 0, 7, 7}\n");
}

TEST(Arrays, KeepWhatFitsWhenResized) {
  Trial trial;
  trial.out("define aa real[2][2]; aa[1][2] := 5; aa[2][1] := 6; define aa real[1][3]");
  EXPECT_EQ(trial.out("print aa"), "{{0, 5, 0}}\n");
}

TEST(Arrays, TakeListsInBraces) {
  Trial trial;
  EXPECT_EQ(trial.out("define bb real[3]; bb := {1, 2+3,\n -4}; print bb"), "{1, 5, -4}\n");
  EXPECT_EQ(trial.out("cc := {{1,2},{3,4}}; print cc[2][1]; cc[1] := {5, 6}; print cc"),
            "3\n{{5, 6},\n {3, 4}}\n");
  EXPECT_TRUE(contains(trial.failure("dd := {{1,2},{3}}"), "the rows of this array differ in length"));
  EXPECT_EQ(trial.out("ee := { print 1 }; ee"), "1\n");
}

TEST(Arrays, InLoops) {
  Trial trial;
  EXPECT_EQ(trial.out("define sq integer[5]; for (i := 1; i <= 5; i++) { sq[i] := i*i }; print sq[4]"),
            "16\n");
}

TEST(Arrays, AreSavedAndUndone) {
  Trial trial("cube.fe");
  trial.out("define aa real[2][2]; aa[2][1] := 0.1\naa[2][1] := 9\nundo");
  EXPECT_EQ(trial.number("aa[2][1]"), 0.1);
  const Folder folder;
  const std::string path = folder / "kept.fe";
  trial.out("save \"" + path + "\"; aa := 5; load \"" + path + "\"");
  EXPECT_EQ(trial.number("aa[2][1]"), 0.1);
  EXPECT_EQ(trial.number("aa[1][1]"), 0);
}

TEST(Arrays, RefuseWhatTheyDoNotHave) {
  Trial trial;
  trial.out("define aa real[3]; x := 1");
  EXPECT_TRUE(contains(trial.failure("aa[4] := 1"), "index 4 is not between 1 and 3"));
  EXPECT_TRUE(contains(trial.failure("print aa[0]"), "index 0 is not between 1 and 3"));
  EXPECT_TRUE(contains(trial.failure("print aa[1][1]"), "an array of 1 dimension takes no 2 indices"));
  EXPECT_TRUE(contains(trial.failure("print aa + 1"), "\"aa\" is an array"));
  EXPECT_TRUE(contains(trial.failure("aa += 1"), "arrays are counted with number by number"));
  EXPECT_TRUE(contains(trial.failure("x[1] := 2"), "this is no array"));
  EXPECT_TRUE(contains(trial.failure("print x[1]"), "this is no array"));
  EXPECT_TRUE(contains(trial.failure("aa[2] := \"text\""), "an array holds numbers"));
  EXPECT_TRUE(contains(trial.failure("define bb real[2]; bb := aa"), "other dimensions"));
  EXPECT_TRUE(contains(trial.failure("define ss string[2]"), "arrays hold numbers"));
}

}  // namespace
}  // namespace lamella::trial
