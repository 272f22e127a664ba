#include "session/history.h"
#include "support/trial.h"

namespace lamella::trial {
namespace {

TEST(Undo, TakesBackWhatChangedTheScene) {
  Trial trial("cube.fe");
  trial.out("refine; vertex[1].x := 0.25; print total_area; set vertex fixed where id < 3");
  EXPECT_EQ(trial.out("undo; print count(vertex where fixed)"), "0\n");
  EXPECT_EQ(trial.out("undo; print vertex[1].x"), "0\n");
  EXPECT_EQ(trial.out("undo; print vertex_count"), "14\n");
  EXPECT_TRUE(contains(trial.failure("undo"), "nothing to undo"));
  EXPECT_EQ(trial.out("redo 2; print vertex_count; print vertex[1].x"), "50\n0.25\n");
  EXPECT_EQ(trial.out("redo; print count(vertex where fixed)"), "2\n");
  EXPECT_TRUE(contains(trial.failure("redo"), "nothing to redo"));
}

TEST(Undo, NamesTheStatement) {
  Trial trial("cube.fe");
  trial.session().set_quiet(false);
  trial.out("refine ;  vertex[1].x := 0.25");
  EXPECT_EQ(trial.out("undo"), "undo: vertex[1].x := 0.25\n");
  EXPECT_EQ(trial.out("undo"), "undo: refine\n");
  EXPECT_EQ(trial.out("redo"), "redo: refine\n");
}

TEST(Undo, CoversVariablesProceduresAndLoadedScenes) {
  Trial trial("cube.fe");
  trial.out("x := 1; x := 2; mygo := { print 1 }");
  trial.out("undo 2");
  EXPECT_EQ(trial.number("x"), 1);
  EXPECT_EQ(trial.number("is_defined(\"mygo\")"), 0);
  trial.out("load " + datafile("double_bubble.fe"));
  EXPECT_EQ(trial.number("body_count"), 2);
  EXPECT_EQ(trial.number("is_defined(\"x\")"), 0);
  trial.out("undo");
  EXPECT_EQ(trial.number("body_count"), 1);
  EXPECT_EQ(trial.number("x"), 1);
}

TEST(Undo, InABlockIsDoneWhenTheBlockIs) {
  Trial trial("cube.fe");
  trial.out("refine; x := 1; { undo } 2");
  EXPECT_EQ(trial.number("vertex_count"), 14);
}

TEST(Undo, WhatIsNewEndsWhatCouldBeRedone) {
  Trial trial("cube.fe");
  trial.out("x := 1; undo; y := 2");
  EXPECT_TRUE(contains(trial.failure("redo"), "nothing to redo"));
}

TEST(Undo, MeasuresFollow) {
  Trial trial("cube.fe");
  const std::string area = trial.out("print total_area");
  trial.out("vertex[1].x := -3; print total_area; undo");
  EXPECT_EQ(trial.out("print total_area"), area);
}

TEST(History, DropsTheOldestStepsWhenMemoryIsShort) {
  Trial trial("cube.fe");
  const std::size_t bytes = trial.session().scene().film.bytes_with_columns();
  session::History history(3 * bytes);
  for (int i = 0; i < 10; ++i) {
    scene::Scene scene = trial.session().scene();
    scene.film.edit_connectivity();  // no longer shared with the others
    history.push(std::move(scene), "step");
  }
  EXPECT_EQ(history.undo_steps(), 3U);
}

TEST(History, ComparesScenes) {
  Trial trial("cube.fe");
  scene::Scene& scene = trial.session().scene();
  const scene::Scene before = scene;
  EXPECT_FALSE(session::differs(before, scene));
  scene.bodies[0].target_volume = 2;
  EXPECT_TRUE(session::differs(before, scene));
  scene = before;
  scene.film.columns(film::ElementKind::vertex).edit("original")->set(0, 0, 5);
  EXPECT_TRUE(session::differs(before, scene));
  scene = before;
  scene.damping = 2;
  EXPECT_TRUE(session::differs(before, scene));
}

}  // namespace
}  // namespace lamella::trial
