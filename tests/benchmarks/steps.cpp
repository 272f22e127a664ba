// What a step costs, in nanoseconds a facet: loading, refining, sweeps, relaxing, evolving.
//
//   cmake --preset bench && cmake --build --preset bench && build-bench/benchmarks
#include <filesystem>
#include <map>

#include <benchmark/benchmark.h>

#include "datafile/read.h"
#include "datafile/write.h"
#include "energy/film_energy.h"
#include "evolution/motion.h"
#include "film/order.h"
#include "language/formula_scope.h"
#include "language/lexer.h"
#include "scene/scene.h"
#include "solve/descent.h"
#include "solve/lbfgs.h"
#include "support/shapes.h"
#include "surgery/average.h"
#include "surgery/equiangulate.h"
#include "surgery/refine.h"
#include "text/whole_file.h"

namespace lamella {
namespace {

using film::Vec3;
using scene::Scene;

// A double bubble of about so many facets, partly relaxed: curved films, a border, two volumes.
const Scene& double_bubble(long facets) {
  static std::map<long, Scene> made;
  Scene& scene = made[facets];
  if (!scene.empty()) return scene;
  scene = datafile::read_datafile(LAMELLA_SOURCE_DIR "/datafiles/double_bubble.fe").scene;
  scene::Monitor monitor;
  while (scene.film.triangle_count() < facets) {
    surgery::refine(scene.film);
    film::restore_spatial_order_if_large(scene.film);
    if (scene.film.triangle_count() > 20000) continue;
    solve::Problem problem(scene);
    solve::LbfgsOptions options;
    options.most_iterations = 15;
    options.motion = solve::MotionKind::full;
    solve::lbfgs(problem, scene, scene.film.edit_positions(), options, monitor);
  }
  return scene;
}

// The same film with no region on either side: what a scene without bodies pays.
Scene without_bodies(const Scene& with) {
  Scene scene = with;
  for (std::uint32_t t = 0; t < scene.film.triangle_rows(); ++t)
    scene.film.set_regions(film::Triangle(t), {});
  scene.bodies.clear();
  return scene;
}

void per_facet(benchmark::State& state, const Scene& scene) {
  const double facets = scene.film.triangle_count();
  state.counters["facets"] = facets;
  state.counters["ns/facet"] = benchmark::Counter(
      facets * 1e-9, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void sizes(benchmark::internal::Benchmark* b) {
  for (const long facets : {10000, 100000, 1000000}) b->Arg(facets);
  b->Unit(benchmark::kMillisecond);
}

void gradient_sweep(benchmark::State& state) {
  const Scene& scene = double_bubble(state.range(0));
  energy::FilmEnergy energy(scene);
  const std::vector<Vec3> x(scene.film.positions().begin(), scene.film.positions().end());
  for (auto _ : state) benchmark::DoNotOptimize(energy.gradient(x));
  per_facet(state, scene);
}
BENCHMARK(gradient_sweep)->Apply(sizes);

void gradient_sweep_no_bodies(benchmark::State& state) {
  const Scene scene = without_bodies(double_bubble(state.range(0)));
  energy::FilmEnergy energy(scene);
  const std::vector<Vec3> x(scene.film.positions().begin(), scene.film.positions().end());
  for (auto _ : state) benchmark::DoNotOptimize(energy.gradient(x));
  per_facet(state, scene);
}
BENCHMARK(gradient_sweep_no_bodies)->Apply(sizes);

void area_and_volumes(benchmark::State& state) {
  const Scene& scene = double_bubble(state.range(0));
  energy::FilmEnergy energy(scene);
  const std::vector<Vec3> x(scene.film.positions().begin(), scene.film.positions().end());
  for (auto _ : state) benchmark::DoNotOptimize(energy.value(x));
  per_facet(state, scene);
}
BENCHMARK(area_and_volumes)->Apply(sizes);

// One step of descent with a line search.
void descend(benchmark::State& state, Scene scene) {
  solve::Problem problem(scene);
  solve::Descent descent(problem);
  double scale = 0;
  const std::span<Vec3> x = scene.film.edit_positions();
  for (auto _ : state) benchmark::DoNotOptimize(descent.step(x, scale, false, HUGE_VAL).energy);
  per_facet(state, scene);
}

void relax_step_descent(benchmark::State& state) {
  descend(state, double_bubble(state.range(0)));
}
BENCHMARK(relax_step_descent)->Apply(sizes);

void relax_step_descent_no_bodies(benchmark::State& state) {
  descend(state, without_bodies(double_bubble(state.range(0))));
}
BENCHMARK(relax_step_descent_no_bodies)->Apply(sizes);

// Every vertex inside a sphere far outside: what a constraint costs that holds nobody yet.
void relax_step_descent_constrained(benchmark::State& state) {
  Scene scene = double_bubble(state.range(0));
  language::LexerStream tokens(
      language::Lexer(text::make_source("wall", "100 - x^2 - y^2 - z^2"), language::LexerMode::datafile));
  scene::LevelSet& wall = scene.level_sets[1];
  wall.formula = language::parse_formula(tokens, language::FormulaKind::space, scene.variables, {});
  wall.sense = scene::Sense::nonnegative;
  wall.global = true;
  descend(state, std::move(scene));
}
BENCHMARK(relax_step_descent_constrained)->Apply(sizes);

// Twenty quasi-Newton iterations, one factorisation among them, divided by twenty.
void relax_iteration_lbfgs(benchmark::State& state) {
  const Scene& scene = double_bubble(state.range(0));
  scene::Monitor monitor;
  solve::LbfgsOptions options;
  options.most_iterations = 20;
  options.tolerance = 1e-30;
  for (auto _ : state) {
    Scene copy = scene;
    solve::Problem problem(copy);
    benchmark::DoNotOptimize(
        solve::lbfgs(problem, copy, copy.film.edit_positions(), options, monitor).energy);
  }
  const double facets = scene.film.triangle_count();
  state.counters["facets"] = facets;
  state.counters["ns/facet"] = benchmark::Counter(
      20 * facets * 1e-9, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}
BENCHMARK(relax_iteration_lbfgs)->Arg(10000)->Arg(100000)->Unit(benchmark::kMillisecond);

void evolve_step(benchmark::State& state) {
  Scene scene = double_bubble(state.range(0));
  evolution::Motion motion(scene);
  for (auto _ : state) benchmark::DoNotOptimize(motion.step(0.3 * motion.bound()));
  per_facet(state, scene);
}
BENCHMARK(evolve_step)->Apply(sizes);

void evolve_step_no_bodies(benchmark::State& state) {
  Scene scene = without_bodies(double_bubble(state.range(0)));
  evolution::Motion motion(scene);
  for (auto _ : state) benchmark::DoNotOptimize(motion.step(0.3 * motion.bound()));
  per_facet(state, scene);
}
BENCHMARK(evolve_step_no_bodies)->Apply(sizes);

void refine(benchmark::State& state) {
  const Scene& scene = double_bubble(state.range(0));
  Scene refined;
  for (auto _ : state) {
    refined = scene;
    surgery::refine(refined.film);
    film::restore_spatial_order_if_large(refined.film);
  }
  per_facet(state, refined);
}
BENCHMARK(refine)->Apply(sizes);

void equiangulate_pass(benchmark::State& state) {
  const Scene& scene = double_bubble(state.range(0));
  for (auto _ : state) {
    Scene copy = scene;
    benchmark::DoNotOptimize(surgery::equiangulate(copy.film));
  }
  per_facet(state, scene);
}
BENCHMARK(equiangulate_pass)->Apply(sizes);

void average_pass(benchmark::State& state) {
  Scene scene = double_bubble(state.range(0));
  for (auto _ : state) benchmark::DoNotOptimize(surgery::average_vertices(scene.film));
  per_facet(state, scene);
}
BENCHMARK(average_pass)->Apply(sizes);

void copy_of_everything(benchmark::State& state) {
  const Scene& scene = double_bubble(state.range(0));
  for (auto _ : state) {
    Scene copy = scene;
    copy.film.edit_connectivity();
    copy.film.edit_positions();
    benchmark::DoNotOptimize(copy.film.positions().data());
  }
  per_facet(state, scene);
}
BENCHMARK(copy_of_everything)->Apply(sizes);

void load_datafile(benchmark::State& state) {
  const Scene& scene = double_bubble(state.range(0));
  const std::string path = (std::filesystem::temp_directory_path() / "lamella-benchmark.fe").string();
  text::write_whole_file(path, datafile::write_datafile(scene));
  for (auto _ : state) benchmark::DoNotOptimize(datafile::read_datafile(path).scene.film.triangle_count());
  std::filesystem::remove(path);
  per_facet(state, scene);
}
BENCHMARK(load_datafile)->Apply(sizes);

void save_datafile(benchmark::State& state) {
  const Scene& scene = double_bubble(state.range(0));
  for (auto _ : state) benchmark::DoNotOptimize(datafile::write_datafile(scene).size());
  per_facet(state, scene);
}
BENCHMARK(save_datafile)->Apply(sizes);

}  // namespace
}  // namespace lamella

BENCHMARK_MAIN();
