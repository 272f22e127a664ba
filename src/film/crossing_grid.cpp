#include "film/crossing_grid.h"

#include <algorithm>
#include <cmath>

namespace lamella::film {

namespace {

constexpr double most_cells = 400;  // that one facet is entered in

double mean_edge(const Film& film) {
  double sum = 0;
  std::uint32_t count = 0;
  for (std::uint32_t i = 0; i < film.edge_rows(); ++i) {
    if (!film.alive(Edge(i))) continue;
    sum += length(film.vector(Edge(i)));
    ++count;
  }
  return sum > 0 ? sum / count : 1;
}

}  // namespace

double CrossingGrid::Range::cells() const {
  double product = 1;
  for (std::size_t k = 0; k < 3; ++k) product *= 1.0 + high[k] - low[k];
  return product;
}

bool CrossingGrid::Range::holds(const Range& other) const {
  for (std::size_t k = 0; k < 3; ++k) {
    if (other.low[k] < low[k] || other.high[k] > high[k]) return false;
  }
  return true;
}

CrossingGrid::CrossingGrid(const Film& film) : film_(film), width_(mean_edge(film)) {
  std::size_t buckets = 64;
  while (buckets < 4 * std::size_t{film.triangle_rows()}) buckets *= 2;
  first_.assign(buckets, no_index);
  entries_.reserve(buckets);
  for (std::uint32_t i = 0; i < film.triangle_rows(); ++i) {
    if (film.alive(Triangle(i))) add(Triangle(i));
  }
}

CrossingGrid::Range CrossingGrid::range(const Box& box) const {
  // Far out, where cells have no numbers any more, all share the outermost ones.
  const auto cell = [&](double x) { return static_cast<int>(std::clamp(std::floor(x / width_), -1e9, 1e9)); };
  return {{cell(box.low.x), cell(box.low.y), cell(box.low.z)},
          {cell(box.high.x), cell(box.high.y), cell(box.high.z)}};
}

std::size_t CrossingGrid::bucket(int i, int j, int k) const {
  const auto mix = [](int n) { return static_cast<std::uint64_t>(static_cast<std::uint32_t>(n)); };
  const std::uint64_t hash =
      mix(i) * 0x9e3779b97f4a7c15U ^ mix(j) * 0xc2b2ae3d27d4eb4fU ^ mix(k) * 0x165667b19e3779f9U;
  return (hash ^ (hash >> 29U)) & (first_.size() - 1);
}

void CrossingGrid::add(Triangle t) {
  if (boxes_.size() < film_.triangle_rows()) {
    boxes_.resize(film_.triangle_rows());
    entered_.resize(film_.triangle_rows(), {{1, 1, 1}, {0, 0, 0}});
  }
  boxes_[t.index] = box_of(film_.points(t));
  const Range cells = range(boxes_[t.index]);
  if (entered_[t.index].holds(cells)) return;
  entered_[t.index] = cells;
  if (cells.cells() > most_cells) {
    large_.push_back(t);
    return;
  }
  for (int i = cells.low[0]; i <= cells.high[0]; ++i) {
    for (int j = cells.low[1]; j <= cells.high[1]; ++j) {
      for (int k = cells.low[2]; k <= cells.high[2]; ++k) {
        std::uint32_t& first = first_[bucket(i, j, k)];
        entries_.push_back({t, first});
        first = static_cast<std::uint32_t>(entries_.size() - 1);
      }
    }
  }
}

void CrossingGrid::add_around(Vertex v) {
  film_.for_each_end(v, [&](EdgeEnd end) {
    film_.for_each_side(end.edge(), [&](Side s) {
      if (film_.tail(film_.edge_of(s)) == v) add(s.triangle());
    });
  });
}

// Calls function(Triangle) once for each facet whose box meets another.
template <class Function>
void CrossingGrid::for_each_near(const Box& box, Function&& function) const {
  met_.resize(film_.triangle_rows());
  ++query_;
  const auto meet = [&](Triangle t) {
    if (met_[t.index] == query_) return;
    met_[t.index] = query_;
    if (boxes_[t.index].meets(box) && film_.alive(t)) function(t);
  };
  for (const Triangle t : large_) meet(t);
  const Range cells = range(box);
  if (cells.cells() > 8 * most_cells) {
    for (const Entry& entry : entries_) meet(entry.facet);
    return;
  }
  for (int i = cells.low[0]; i <= cells.high[0]; ++i) {
    for (int j = cells.low[1]; j <= cells.high[1]; ++j) {
      for (int k = cells.low[2]; k <= cells.high[2]; ++k) {
        for (std::uint32_t n = first_[bucket(i, j, k)]; n != no_index; n = entries_[n].next)
          meet(entries_[n].facet);
      }
    }
  }
}

bool CrossingGrid::crosses(std::span<const FacetShape> made, std::span<const Triangle> gone) const {
  if (made.empty()) return false;
  for (std::size_t a = 0; a < made.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      if (shapes_cross(made[a], made[b])) return true;
    }
  }
  // One walk through the cells for all of them: they lie side by side.
  Box around = box_of(made[0].points);
  for (const FacetShape& shape : made) around = joined(around, box_of(shape.points));
  bool found = false;
  for_each_near(around, [&](Triangle t) {
    if (found || std::find(gone.begin(), gone.end(), t) != gone.end()) return;
    const FacetShape other = shape_of(film_, t);
    found = std::any_of(made.begin(), made.end(), [&](const FacetShape& shape) {
      return box_of(shape.points).meets(boxes_[t.index]) && shapes_cross(shape, other);
    });
  });
  return found;
}

std::vector<Triangle> CrossingGrid::crossing(Triangle t, std::size_t most) const {
  std::vector<Triangle> found;
  const FacetShape shape = shape_of(film_, t);
  for_each_near(boxes_[t.index], [&](Triangle other) {
    if (other > t && found.size() < most && shapes_cross(shape, shape_of(film_, other)))
      found.push_back(other);
  });
  return found;
}

}  // namespace lamella::film
