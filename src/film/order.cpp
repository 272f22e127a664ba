#include "film/order.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace lamella::film {

namespace {

constexpr int bits_per_axis = 16;

// The place of a cell along the Hilbert curve, by the transpose method of J. Skilling, "Programming the
// Hilbert curve", AIP Conference Proceedings 707 (2004).
std::uint64_t hilbert_index(std::array<std::uint32_t, 3> x) {
  constexpr std::uint32_t top = 1U << (bits_per_axis - 1);
  for (std::uint32_t q = top; q > 1; q >>= 1U) {
    const std::uint32_t p = q - 1;
    for (std::size_t i = 0; i < 3; ++i) {
      if ((x[i] & q) != 0) {
        x[0] ^= p;
      } else {
        const std::uint32_t t = (x[0] ^ x[i]) & p;
        x[0] ^= t;
        x[i] ^= t;
      }
    }
  }
  for (std::size_t i = 1; i < 3; ++i) x[i] ^= x[i - 1];
  std::uint32_t t = 0;
  for (std::uint32_t q = top; q > 1; q >>= 1U) {
    if ((x[2] & q) != 0) t ^= q - 1;
  }
  for (std::uint32_t& axis : x) axis ^= t;

  std::uint64_t index = 0;
  for (int bit = bits_per_axis - 1; bit >= 0; --bit) {
    for (const std::uint32_t axis : x) index = (index << 1U) | ((axis >> static_cast<unsigned>(bit)) & 1U);
  }
  return index;
}

std::vector<std::uint64_t> curve_places(std::span<const Vec3> positions) {
  Vec3 low = positions[0];
  Vec3 high = positions[0];
  for (const Vec3& p : positions) {
    for (int axis = 0; axis < 3; ++axis) {
      low[axis] = std::min(low[axis], p[axis]);
      high[axis] = std::max(high[axis], p[axis]);
    }
  }
  const Vec3 size = high - low;
  const double extent = std::max({size.x, size.y, size.z, 1e-300});
  const double cells = (1 << bits_per_axis) - 1;
  std::vector<std::uint64_t> places;
  places.reserve(positions.size());
  for (const Vec3& p : positions) {
    std::array<std::uint32_t, 3> cell{};
    for (int axis = 0; axis < 3; ++axis) {
      cell[static_cast<std::size_t>(axis)] =
          static_cast<std::uint32_t>((p[axis] - low[axis]) / extent * cells);
    }
    places.push_back(hilbert_index(cell));
  }
  return places;
}

template <class Key>
std::vector<std::uint32_t> sorted_rows(std::uint32_t rows, Key&& key) {
  std::vector<std::uint32_t> order(rows);
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
  return order;
}

}  // namespace

void restore_spatial_order(Film& film) {
  if (film.vertex_rows() == 0) return;
  const std::vector<std::uint64_t> place = curve_places(film.positions());
  const std::vector<std::uint32_t> vertices =
      sorted_rows(film.vertex_rows(), [&](std::uint32_t v) { return place[v]; });
  std::vector<std::uint32_t> rank(vertices.size());
  for (std::size_t i = 0; i < vertices.size(); ++i) rank[vertices[i]] = static_cast<std::uint32_t>(i);

  const auto first_corner = [&](const auto& corners) {
    std::uint32_t first = no_index;
    for (const Vertex v : corners) first = std::min(first, rank[v.index]);
    return first;
  };
  film.renumber(
      vertices,
      sorted_rows(film.edge_rows(), [&](std::uint32_t e) { return first_corner(film.ends(Edge(e))); }),
      sorted_rows(film.triangle_rows(),
                  [&](std::uint32_t t) { return first_corner(film.corners(Triangle(t))); }));
}

double mean_row_distance(const Film& film) {
  double sum = 0;
  for (std::uint32_t t = 0; t < film.triangle_rows(); ++t) {
    const auto& corner = film.corners(Triangle(t));
    if (!corner[0].valid()) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      sum += std::abs(static_cast<double>(corner[k].index) - static_cast<double>(corner[(k + 1) % 3].index));
    }
  }
  return film.triangle_count() > 0 ? sum / (3.0 * film.triangle_count()) : 0;
}

}  // namespace lamella::film
