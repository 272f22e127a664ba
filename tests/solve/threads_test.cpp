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

// What `move`, which returns an energy, makes of the large film on so many threads.
template <class Move>
Result on_threads(int threads, const Move& move) {
  const int before = omp_get_max_threads();
  omp_set_num_threads(threads);
  scene::Scene scene = large_film();
  solve::Problem problem(scene);
  Result result;
  result.energy = move(scene, problem);
  result.volume = problem.energy().volumes()[1];
  result.positions.assign(scene.film.positions().begin(), scene.film.positions().end());
  omp_set_num_threads(before);
  EXPECT_TRUE(std::isfinite(result.energy));
  return result;
}

double three_steps(scene::Scene& scene, solve::Problem& problem) {
  solve::Descent descent(problem);
  double scale = 0;
  double energy = 0;
  for (int step = 0; step < 3; ++step)
    energy = descent.step(scene.film.edit_positions(), scale, false, HUGE_VAL).energy;
  return energy;
}

double newton_step(scene::Scene& scene, solve::Problem& problem) {
  solve::Newton method(problem, scene.film, solve::MotionKind::normal);
  double energy = 0;
  problem.linearise_and_restore(scene.film.edit_positions(), energy);
  return method.step(scene.film.edit_positions(), solve::SaddlePolicy::shift).energy;
}

TEST(Threads, DoNotChangeTheResult) {
  const Result one = on_threads(1, three_steps);
  EXPECT_TRUE(one == on_threads(2, three_steps));
  EXPECT_TRUE(one == on_threads(3, three_steps));
}

TEST(Threads, DoNotChangeAStepOfNewtonsMethod) {
  EXPECT_TRUE(on_threads(1, newton_step) == on_threads(2, newton_step));
}

}  // namespace
}  // namespace lamella
