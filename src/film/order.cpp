#include "film/order.h"

#include <algorithm>
#include <cmath>

namespace lamella::film {

namespace {

constexpr std::uint32_t fewest_facets = 49152;

// Vertices in the order in which a walk along the edges, nearest first, meets them; piece after piece.
std::vector<std::uint32_t> breadth_first(const Film& film) {
  std::vector<std::uint32_t> order;
  order.reserve(film.vertex_rows());
  std::vector<std::uint8_t> met(film.vertex_rows(), 0);
  const auto meet = [&](Vertex v) {
    if (met[v.index] != 0) return;
    met[v.index] = 1;
    order.push_back(v.index);
  };
  for (std::uint32_t start = 0; start < film.vertex_rows(); ++start) {
    const std::size_t first = order.size();
    meet(Vertex(start));
    for (std::size_t i = first; i < order.size(); ++i) {
      film.for_each_end(Vertex(order[i]), [&](EdgeEnd end) { meet(film.head(end.outward())); });
    }
  }
  return order;
}

// Rows by ascending key, equal keys in their old order; keys lie below `keys`.
std::vector<std::uint32_t> sorted_by(std::size_t keys, const std::vector<std::uint32_t>& key) {
  std::vector<std::uint32_t> first(keys + 1, 0);
  for (const std::uint32_t k : key) ++first[k + 1];
  for (std::size_t k = 0; k < keys; ++k) first[k + 1] += first[k];
  std::vector<std::uint32_t> order(key.size());
  for (std::uint32_t i = 0; i < key.size(); ++i) order[first[key[i]]++] = i;
  return order;
}

}  // namespace

void restore_spatial_order(Film& film) {
  const std::vector<std::uint32_t> vertices = breadth_first(film);
  std::vector<std::uint32_t> rank(vertices.size());
  for (std::uint32_t i = 0; i < vertices.size(); ++i) rank[vertices[i]] = i;
  const auto first_of = [&](const auto& corners) {
    std::uint32_t first = no_index;
    for (const Vertex v : corners) first = std::min(first, rank[v.index]);
    return first;
  };
  std::vector<std::uint32_t> edge_key;
  std::vector<std::uint32_t> triangle_key;
  for (const auto& ends : film.connectivity().edge_vertices) edge_key.push_back(first_of(ends));
  for (const auto& corners : film.connectivity().triangle_vertices) triangle_key.push_back(first_of(corners));
  film.renumber(vertices, sorted_by(vertices.size(), edge_key), sorted_by(vertices.size(), triangle_key));
}

void restore_spatial_order_if_large(Film& film) {
  if (film.triangle_count() < fewest_facets) return;
  // Neighbouring rows of a well ordered surface lie within a few of its widths.
  if (mean_row_distance(film) > 4 * std::sqrt(static_cast<double>(film.vertex_count())))
    restore_spatial_order(film);
}

double mean_row_distance(const Film& film) {
  double sum = 0;
  for (const auto& corner : film.connectivity().triangle_vertices) {
    if (!corner[0].valid()) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      sum += std::abs(static_cast<double>(corner[k].index) - static_cast<double>(corner[(k + 1) % 3].index));
    }
  }
  return film.triangle_count() > 0 ? sum / (3.0 * film.triangle_count()) : 0;
}

}  // namespace lamella::film
