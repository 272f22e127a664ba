// Energies, volumes and their derivatives in periodic films, held against finite differences and against
// what does not depend on how the film is written down.
#include <random>

#include <gtest/gtest.h>

#include "datafile/read.h"
#include "energy/film_energy.h"
#include "energy/measure.h"
#include "film/check.h"
#include "support/differences.h"

namespace lamella::energy {
namespace {

using film::Vec3;
using film::Vertex;

scene::Scene load(const std::string& name) {
  return datafile::read_datafile(std::string(LAMELLA_SOURCE_DIR) + "/datafiles/" + name).scene;
}

scene::Scene read(const std::string& text) {
  return datafile::read_datafile(text::make_source("test", text)).scene;
}

// One cell whose three faces have it on both sides: a vertex, and edges from it to its images.
constexpr const char* one_cube = R"(
torus_filled
vertices
1 0.1 0.2 0.3
edges
1 1 1 + * *
2 1 1 * + *
3 1 1 * * +
faces
1 1 2 -1 -2
2 2 3 -2 -3
3 3 1 -3 -1
bodies
1 1 -1 2 -2 3 -3 volume 1
)";

// A body between two films that go all around: z from 0.25 to 0.75.
constexpr const char* slab = R"(
torus
vertices
1 0 0 0.25
2 0.4 0.3 0.25
3 0 0 0.75
4 0.4 0.3 0.75
edges
1 1 1 + * *
2 1 1 * + *
3 1 2 * * *
4 2 1 + * *
5 2 1 + + *
6 2 1 * + *
7 3 3 + * *
8 3 3 * + *
9 3 4 * * *
10 4 3 + * *
11 4 3 + + *
12 4 3 * + *
faces
1 1 -4 -3
2 4 2 -5
3 5 -1 -6
4 6 -2 3
5 7 -10 -9
6 10 8 -11
7 11 -7 -12
8 12 -8 9
bodies
1 -1 -2 -3 -4 5 6 7 8 volume 0.5
)";

void jitter(film::Film& film, double by, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> draw(-by, by);
  for (Vec3& p : film.edit_positions()) p += Vec3{draw(random), draw(random), draw(random)};
}

void move_by_random_periods(film::Film& film, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_int_distribution<int> draw(-2, 2);
  for (std::uint32_t v = 0; v < film.vertex_rows(); ++v)
    film.move_by_periods(Vertex(v), {{draw(random), draw(random), draw(random)}});
}

TEST(PeriodicFilm, OneCellFillsTheCube) {
  const scene::Scene scene = read(one_cube);
  EXPECT_TRUE(film::check(scene.film).empty());
  const Measures m = measure(scene);
  EXPECT_NEAR(m.area, 3, 1e-14);
  EXPECT_NEAR(m.volumes[1], 1, 1e-14);
}

TEST(PeriodicFilm, KelvinsCellsHalveTheCube) {
  const Measures m = measure(load("kelvin.fe"));
  EXPECT_NEAR(m.area, 0.75 * (1 + 2 * std::sqrt(3.0)), 1e-13);
  EXPECT_NEAR(m.volumes[1], 0.5, 1e-14);
  EXPECT_NEAR(m.volumes[2], 0.5, 1e-14);
}

TEST(PeriodicFilm, ABodyThatGoesAroundSpaceHasItsVolume) {
  scene::Scene scene = read(slab);
  ASSERT_TRUE(film::check(scene.film).empty());
  EXPECT_NEAR(measure(scene).volumes[1], 0.5, 1e-14);
  for (std::uint32_t v = 2; v < 4; ++v) scene.film.edit_positions()[v].z += 0.07;
  EXPECT_NEAR(measure(scene).volumes[1], 0.57, 1e-14);
}

class Periodic : public testing::TestWithParam<const char*> {
 protected:
  static scene::Scene scene() {
    const std::string name = GetParam();
    scene::Scene result = name == "one cube" ? read(one_cube) : name == "slab" ? read(slab) : load(name);
    jitter(result.film, 0.03, 4);
    return result;
  }
};

TEST_P(Periodic, IsTheSameWhereverItsVerticesAreWritten) {
  const scene::Scene plain = scene();
  const Measures wanted = measure(plain);
  for (const unsigned seed : {1U, 2U, 3U}) {
    scene::Scene moved = plain;
    move_by_random_periods(moved.film, seed);
    EXPECT_TRUE(film::check(moved.film).empty());
    const Measures m = measure(moved);
    EXPECT_NEAR(m.area, wanted.area, 1e-12);
    for (std::size_t r = 1; r < m.volumes.size(); ++r) EXPECT_NEAR(m.volumes[r], wanted.volumes[r], 1e-12);
    moved.film.gather_in_cell();
    EXPECT_NEAR(measure(moved).area, wanted.area, 1e-12);
    const Vec3 all{0.3, -1.7, 0.2};
    for (Vec3& p : moved.film.edit_positions()) p += all;
    const Measures shifted = measure(moved);
    for (std::size_t r = 1; r < m.volumes.size(); ++r)
      EXPECT_NEAR(shifted.volumes[r], wanted.volumes[r], 1e-12);
  }
}

TEST_P(Periodic, GradientsAgreeWithDifferences) {
  scene::Scene s = scene();
  move_by_random_periods(s.film, 5);
  FilmEnergy energy(s);
  const std::vector<Vec3> x(s.film.positions().begin(), s.film.positions().end());
  energy.gradient(x);
  const std::vector<VertexLine> lines(energy.lines().begin(), energy.lines().end());
  const auto wanted = test::gradient_by_differences(
      x, [&](const std::vector<Vec3>& y) { return energy.value(y); }, 1e-4);
  for (std::size_t v = 0; v < x.size(); ++v) EXPECT_LT(length(lines[v].gradient - wanted[v]), 1e-8) << v;

  energy.gradient(x);
  std::vector<std::vector<Vec3>> rows(energy.constrained().size(), std::vector<Vec3>(x.size()));
  energy.volume_gradient().for_each(
      [&](std::uint32_t v, int row, const Vec3& g) { rows[static_cast<std::size_t>(row)][v] = g; });
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto by_differences = test::gradient_by_differences(
        x,
        [&](const std::vector<Vec3>& y) {
          energy.value(y);
          return energy.volumes()[energy.constrained()[i].index];
        },
        1e-4);
    for (std::size_t v = 0; v < x.size(); ++v) EXPECT_LT(length(rows[i][v] - by_differences[v]), 1e-8) << v;
  }
}

INSTANTIATE_TEST_SUITE_P(Films, Periodic,
                         testing::Values("one cube", "slab", "kelvin.fe", "weaire_phelan.fe"));

}  // namespace
}  // namespace lamella::energy
