#include "film/intersections.h"

#include <algorithm>
#include <array>

#include "film/box_tree.h"
#include "film/predicates.h"

namespace lamella::film {

namespace {

using Points = std::array<Vec3, 3>;

bool crosses_any_edge(const Points& of, const Points& triangle) {
  for (std::size_t k = 0; k < 3; ++k) {
    if (segment_meets_triangle(of[k], of[(k + 1) % 3], triangle[0], triangle[1], triangle[2])) return true;
  }
  return false;
}

// Whether two corners at least, and all of them, lie strictly on one side of a triangle's plane.
bool lies_beside(std::span<const Vec3> corners, const Points& triangle) {
  const int side = orientation(triangle[0], triangle[1], triangle[2], corners[0]);
  return side != 0 && std::all_of(corners.begin() + 1, corners.end(), [&](const Vec3& p) {
           return orientation(triangle[0], triangle[1], triangle[2], p) == side;
         });
}

bool facets_apart(const Points& a, const Points& b) {
  return lies_beside(b, a) || lies_beside(a, b);
}

// Facets that share one corner, each turned to begin with it: they cross where the side opposite to it, of
// one of them, meets the other.
bool cross_beyond_corner(const Points& a, const Points& b) {
  if (lies_beside({&b[1], 2}, a) || lies_beside({&a[1], 2}, b)) return false;
  return segment_meets_triangle(a[1], a[2], b[0], b[1], b[2]) ||
         segment_meets_triangle(b[1], b[2], a[0], a[1], a[2]);
}

// Facets that share the side p, q: they overlap where they lie in one plane, folded onto each other.
bool fold_flat(const Vec3& p, const Vec3& q, const Vec3& a, const Vec3& b) {
  if (orientation(p, q, a, b) != 0) return false;
  const Vec3 along = q - p;
  const Vec3 u = cross(along, a - p);
  return dot(u, cross(along, b - p)) > 0;
}

Points from_corner(const Points& points, std::size_t k) {
  return {points[k], points[(k + 1) % 3], points[(k + 2) % 3]};
}

Box box_of_facet(const Film& film, Triangle t) {
  return box_of(film.points(t));
}

// All live facets in a tree.
class FacetTree {
 public:
  explicit FacetTree(const Film& film) : tree_(boxes(film)) {}

  template <class Function>
  void for_each_near(const Box& box, Function&& function) const {
    tree_.for_each_met(box, [&](std::uint32_t i) { function(live_[i]); });
  }

 private:
  std::vector<Box> boxes(const Film& film) {
    std::vector<Box> result;
    for (std::uint32_t i = 0; i < film.triangle_rows(); ++i) {
      if (!film.alive(Triangle(i))) continue;
      live_.emplace_back(i);
      result.push_back(box_of_facet(film, Triangle(i)));
    }
    return result;
  }

  std::vector<Triangle> live_;
  BoxTree tree_;
};

}  // namespace

FacetShape shape_of(const Film& film, Triangle t) {
  return {film.corners(t), film.points(t)};
}

bool facets_cross(const Film& film, Triangle a, Triangle b) {
  return shapes_cross(shape_of(film, a), shape_of(film, b));
}

bool shapes_cross(const FacetShape& a, const FacetShape& b) {
  const auto& [ca, pa] = a;
  const auto& [cb, pb] = b;
  std::array<std::pair<std::size_t, std::size_t>, 3> shared;
  std::size_t count = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (ca[i] == cb[k]) shared[count++] = {i, k};
    }
  }
  if (count == 0 && facets_apart(pa, pb)) return false;
  if (count == 0) return crosses_any_edge(pa, pb) || crosses_any_edge(pb, pa);
  if (count == 1)
    return cross_beyond_corner(from_corner(pa, shared[0].first), from_corner(pb, shared[0].second));
  if (count == 3) return true;
  const std::size_t third_a = 3 - shared[0].first - shared[1].first;
  const std::size_t third_b = 3 - shared[0].second - shared[1].second;
  return fold_flat(pa[shared[0].first], pa[shared[1].first], pa[third_a], pb[third_b]);
}

namespace {

// Few facets are compared with all whose boxes meet the box of them all: no tree is worth making for them.
constexpr std::size_t few = 32;

std::vector<std::pair<Triangle, Triangle>> intersections_of_few(const Film& film,
                                                                std::span<const Triangle> of,
                                                                std::size_t most) {
  std::vector<std::pair<Triangle, Triangle>> found;
  std::vector<std::pair<Triangle, Box>> list;
  for (const Triangle t : of) {
    if (film.alive(t)) list.emplace_back(t, box_of_facet(film, t));
  }
  if (list.empty()) return found;
  Box around = list[0].second;
  for (const auto& [t, box] : list) around = joined(around, box);
  const auto meet = [&](Triangle other) {
    const Box box = box_of_facet(film, other);
    if (!box.meets(around)) return;
    const bool listed = std::find(of.begin(), of.end(), other) != of.end();
    for (const auto& [t, own] : list) {
      if (t == other || (listed && other < t) || found.size() >= most) continue;
      if (own.meets(box) && facets_cross(film, t, other)) found.emplace_back(t, other);
    }
  };
  for (std::uint32_t i = 0; i < film.triangle_rows(); ++i) {
    if (film.alive(Triangle(i))) meet(Triangle(i));
  }
  return found;
}

}  // namespace

std::vector<std::pair<Triangle, Triangle>> self_intersections(const Film& film, std::span<const Triangle> of,
                                                              std::size_t most) {
  if (of.size() <= few) return intersections_of_few(film, of, most);
  std::vector<std::pair<Triangle, Triangle>> found;
  const FacetTree tree(film);
  std::vector<std::uint8_t> listed(film.triangle_rows());
  for (const Triangle t : of) listed[t.index] = 1;
  for (const Triangle t : of) {
    if (found.size() >= most) break;
    if (!film.alive(t)) continue;
    tree.for_each_near(box_of_facet(film, t), [&](Triangle other) {
      if (other == t || (listed[other.index] != 0 && other < t) || found.size() >= most) return;
      if (facets_cross(film, t, other)) found.emplace_back(t, other);
    });
  }
  return found;
}

std::vector<std::pair<Triangle, Triangle>> self_intersections(const Film& film, std::size_t most) {
  std::vector<Triangle> all;
  for (std::uint32_t i = 0; i < film.triangle_rows(); ++i) all.emplace_back(i);
  return self_intersections(film, all, most);
}

}  // namespace lamella::film
