#include "evolution/new_mesh.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "energy/triangle.h"
#include "scene/constraint_sets.h"
#include "surgery/remesh.h"
#include "surgery/sizing.h"

namespace lamella::evolution {

namespace {

constexpr int most_rounds = 10;
constexpr surgery::RemeshOptions band{1.4, 0.7, 0.05, 0.15, 1};

using film::Film;
using film::Triangle;

// The regions on both sides of a facet, whichever is in front.
std::pair<std::uint32_t, std::uint32_t> film_of(const Film& film, Triangle t) {
  const film::RegionPair regions = film.regions(t);
  return std::minmax({regions.front.index, regions.behind.index});
}

// The side of a regular facet of the mean area of each film.
std::map<std::pair<std::uint32_t, std::uint32_t>, double> sides_of_films(const Film& film) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::pair<double, double>> sums;
  for (std::uint32_t t = 0; t < film.triangle_rows(); ++t) {
    if (!film.alive(Triangle(t))) continue;
    auto& [area, count] = sums[film_of(film, Triangle(t))];
    const auto p = film.points(Triangle(t));
    area += energy::triangle_area(p[0], p[1], p[2]);
    count += 1;
  }
  std::map<std::pair<std::uint32_t, std::uint32_t>, double> sides;
  for (const auto& [key, sum] : sums) sides[key] = std::sqrt(4 / std::sqrt(3.0) * sum.first / sum.second);
  return sides;
}

void size_by_films(Film& film, double finer) {
  const auto sides = sides_of_films(film);
  std::vector<double> sizes(film.vertex_rows(), HUGE_VAL);
  for (std::uint32_t t = 0; t < film.triangle_rows(); ++t) {
    if (!film.alive(Triangle(t))) continue;
    const double side = sides.at(film_of(film, Triangle(t))) / finer;
    for (const film::Vertex v : film.corners(Triangle(t))) sizes[v.index] = std::min(sizes[v.index], side);
  }
  surgery::set_sizes(
      film, [&](film::Vertex v) { return sizes[v.index]; }, 0, HUGE_VAL);
}

}  // namespace

void make_new_mesh(scene::Scene& scene, double finer) {
  const bool sized = surgery::has_sizes(scene.film);
  if (!sized) size_by_films(scene.film, finer);
  for (int round = 0; round < most_rounds; ++round) {
    const surgery::RemeshReport made = surgery::remesh(scene, band);
    scene.film.compact();
    if (made.operations() == 0) break;
  }
  if (!sized) scene.film.columns(film::ElementKind::vertex).remove(surgery::size_column);
  scene::constrain_vertices(scene);
}

}  // namespace lamella::evolution
