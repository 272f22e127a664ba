// Whether facets that are about to be made would pass through the film, asked again and again while the film
// changes.
#pragma once

#include <span>
#include <vector>

#include "film/box_tree.h"
#include "film/film.h"
#include "film/intersections.h"

namespace lamella::film {

// The facets of a film in the cells of a grid as wide as the film's edges are on average. Facets that change
// are added once more where they leave the cells that they are in; what a cell still holds of them, or of
// facets that are gone, costs time and no more. Not for periodic films.
class CrossingGrid {
 public:
  explicit CrossingGrid(const Film& film);

  // A facet that was made, or whose corners were moved.
  void add(Triangle t);
  // All facets at a vertex.
  void add_around(Vertex v);
  // Whether any of some facets meets another of them, or one of the film that is not about to go, anywhere
  // but at common corners and edges.
  bool crosses(std::span<const FacetShape> made, std::span<const Triangle> gone) const;
  // The facets of the film after one of its facets that cross it, at most so many.
  std::vector<Triangle> crossing(Triangle t, std::size_t most) const;

 private:
  struct Entry {
    Triangle facet;
    std::uint32_t next = no_index;
  };
  struct Range {
    std::array<int, 3> low;
    std::array<int, 3> high;
    double cells() const;
    bool holds(const Range& other) const;
  };
  Range range(const Box& box) const;
  std::size_t bucket(int i, int j, int k) const;
  template <class Function>
  void for_each_near(const Box& box, Function&& function) const;

  const Film& film_;
  double width_ = 1;
  std::vector<Box> boxes_;            // of each facet when it was added last
  std::vector<Range> entered_;        // the last range of cells that each was entered in
  std::vector<std::uint32_t> first_;  // entry of each bucket
  std::vector<Entry> entries_;
  std::vector<Triangle> large_;             // that would fill too many cells
  mutable std::vector<std::uint32_t> met_;  // the last query that met a facet
  mutable std::uint32_t query_ = 0;
};

}  // namespace lamella::film
