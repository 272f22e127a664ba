#include "surgery/sizing.h"

#include <algorithm>
#include <cmath>
#include <queue>

#include "surgery/skinny.h"

namespace lamella::surgery {

using film::Edge;
using film::EdgeEnd;
using film::ElementKind;
using film::Film;
using film::Reals;
using film::Vertex;

namespace {

double mean_length(const Film& film, Vertex v) {
  double sum = 0;
  int count = 0;
  film.for_each_end(v, [&](EdgeEnd end) {
    sum += length(film.vector(end.outward()));
    ++count;
  });
  return count > 0 ? sum / count : 0;
}

Reals& sizes_of(Film& film) {
  film::Columns& columns = film.columns(ElementKind::vertex);
  film::Column* column = columns.edit(size_column);
  if (column == nullptr)
    column = &columns.add(film::real_column(size_column, 0, 1, film::Inheritance::New::mean));
  column->inheritance.on_merge = film::Inheritance::Merge::mean;
  return std::get<Reals>(column->data);
}

// Lowers sizes until they grow by no more than the steepest grading along every edge, smallest first.
void grade(const Film& film, Reals& sizes) {
  using Entry = std::pair<double, std::uint32_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> waiting;
  for (std::uint32_t v = 0; v < sizes.size(); ++v) {
    if (film.alive(Vertex(v)) && sizes[v] > 0) waiting.emplace(sizes[v], v);
  }
  while (!waiting.empty()) {
    const auto [size, row] = waiting.top();
    waiting.pop();
    if (size > sizes[row]) continue;
    film.for_each_end(Vertex(row), [&](EdgeEnd end) {
      const std::uint32_t other = film.head(end.outward()).index;
      const double most = size + steepest_grading * length(film.vector(end.outward()));
      if (sizes[other] <= most) return;
      sizes[other] = most;
      waiting.emplace(most, other);
    });
  }
}

}  // namespace

bool has_sizes(const Film& film) {
  return !film.columns(ElementKind::vertex).reals(size_column).empty();
}

double size_of(const Film& film, Vertex v) {
  const auto sizes = film.columns(ElementKind::vertex).reals(size_column);
  return !sizes.empty() && sizes[v.index] > 0 ? sizes[v.index] : mean_length(film, v);
}

double size_of(const Film& film, Edge e) {
  return 0.5 * (size_of(film, film.ends(e)[0]) + size_of(film, film.ends(e)[1]));
}

void keep_sizes(Film& film) {
  bool complete = has_sizes(film);
  Reals& sizes = sizes_of(film);
  for (std::uint32_t v = 0; v < sizes.size() && complete; ++v)
    complete = sizes[v] > 0 || !film.alive(Vertex(v)) || !film.first_end(Vertex(v)).valid();
  if (complete) return;
  const Reals old = sizes;
  for (std::uint32_t v = 0; v < sizes.size(); ++v) {
    if (film.alive(Vertex(v)) && !(old[v] > 0)) sizes[v] = mean_length(film, Vertex(v));
  }
}

void halve_sizes(Film& film) {
  if (!has_sizes(film)) return;
  for (double& size : sizes_of(film)) size *= 0.5;
}

void forget_sizes(Film& film, std::uint32_t first) {
  if (!has_sizes(film)) return;
  Reals& sizes = sizes_of(film);
  for (std::uint32_t v = first; v < film.vertex_rows(); ++v) {
    if (!film.alive(Vertex(v))) continue;
    sizes[v] = 0;
    film.for_each_end(Vertex(v), [&](EdgeEnd end) { sizes[film.head(end.outward()).index] = 0; });
  }
}

void set_sizes(Film& film, const std::function<double(Vertex)>& size, double least, double most) {
  Reals sizes(film.vertex_rows());
  for (std::uint32_t v = 0; v < sizes.size(); ++v) {
    if (film.alive(Vertex(v))) sizes[v] = std::clamp(size(Vertex(v)), least, most);
  }
  grade(film, sizes);
  sizes_of(film) = std::move(sizes);
}

// The turn at each edge over the distance between the centres of its facets is a curvature; the largest
// counts.
double size_for_curvature(const Film& film, Vertex v, double turn) {
  double curvature = 0;
  film.for_each_end(v, [&](EdgeEnd end) {
    const Edge e = end.edge();
    const film::Side first = film.first_side(e);
    if (!first.valid() || film.valence(e) != 2) return;
    double across = 0;
    film.for_each_side(e, [&](film::Side s) {
      const auto p = film.points(s.triangle());
      across += length(cross(p[1] - p[0], p[2] - p[0])) / (3 * length(film.vector(end.outward())));
    });
    if (across > 0) curvature = std::max(curvature, fold_angle(film, e) / across);
  });
  return curvature > 0 ? turn / curvature : HUGE_VAL;
}

}  // namespace lamella::surgery
