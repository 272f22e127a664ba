// Work shared out over threads: the same to the bit for any number of them.
#include <gtest/gtest.h>
#include <omp.h>

#include "energy/film_energy.h"
#include "solve/descent.h"
#include "solve/newton.h"
#include "support/shapes.h"
#include "surgery/refine.h"

namespace lamella {
namespace {

// A cube of 24 * 4^5 facets whose film is not flat.
scene::Scene large_film() {
  scene::Scene scene = test::cube();
  while (scene.film.triangle_count() < 60000) surgery::refine(scene.film);
  for (film::Vec3& p : scene.film.edit_positions()) p += 0.05 * film::Vec3{p.y * p.y, p.z * p.x, p.x * p.x};
  return scene;
}

struct Result {
  double energy = 0;
  double volume = 0;
  std::vector<film::Vec3> positions;
  friend bool operator==(const Result&, const Result&) = default;
};

Result three_steps(int threads) {
  omp_set_num_threads(threads);
  scene::Scene scene = large_film();
  solve::Problem problem(scene);
  solve::Descent descent(problem);
  double scale = 0;
  Result result;
  for (int step = 0; step < 3; ++step)
    result.energy = descent.step(scene.film.edit_positions(), scale, false, HUGE_VAL).energy;
  result.volume = problem.energy().volumes()[1];
  result.positions.assign(scene.film.positions().begin(), scene.film.positions().end());
  return result;
}

TEST(Threads, DoNotChangeTheResult) {
  const int before = omp_get_max_threads();
  const Result one = three_steps(1);
  const Result two = three_steps(2);
  const Result three = three_steps(3);
  omp_set_num_threads(before);
  EXPECT_TRUE(one == two);
  EXPECT_TRUE(one == three);
}

Result newton_step(int threads) {
  omp_set_num_threads(threads);
  scene::Scene scene = large_film();
  solve::Problem problem(scene);
  solve::Newton method(problem, scene.film, solve::MotionKind::normal);
  Result result;
  problem.linearise_and_restore(scene.film.edit_positions(), result.energy);
  result.energy = method.step(scene.film.edit_positions(), solve::SaddlePolicy::shift).energy;
  result.positions.assign(scene.film.positions().begin(), scene.film.positions().end());
  return result;
}

TEST(Threads, DoNotChangeAStepOfNewtonsMethod) {
  const int before = omp_get_max_threads();
  const Result one = newton_step(1);
  const Result two = newton_step(2);
  omp_set_num_threads(before);
  EXPECT_TRUE(std::isfinite(one.energy));
  EXPECT_TRUE(one == two);
}

}  // namespace
}  // namespace lamella
