#include "picture/sheets.h"

#include <cmath>
#include <span>

namespace lamella::picture {

using film::Film;
using film::Side;
using film::Triangle;
using film::Vec3;

namespace {

// A corner of a triangle in a walk around its vertex, with the triangle's winding relative to where the walk
// began.
struct Corner {
  Triangle triangle;
  int k = 0;
  bool flipped = false;

  std::uint32_t row() const { return 3 * triangle.index + static_cast<std::uint32_t>(k); }
  friend bool operator==(const Corner&, const Corner&) = default;
};

class SheetFinder {
 public:
  SheetFinder(const Film& film, double crease)
      : film_(film), smallest_cosine_(std::cos(crease * M_PI / 180)) {}

  Sheets find() {
    find_unit_normals();
    find_smooth_edges();
    sheets_.of_corner.assign(3 * std::size_t{film_.triangle_rows()}, film::no_index);
    sheets_.vertices.reserve(film_.vertex_count());
    for (std::uint32_t t = 0; t < film_.triangle_rows(); ++t) {
      if (!film_.alive(Triangle(t))) continue;
      for (int k = 0; k < 3; ++k) {
        const Corner corner{Triangle(t), k};
        if (sheets_.of_corner[corner.row()] == film::no_index) gather(corner);
      }
    }
    return std::move(sheets_);
  }

 private:
  void find_unit_normals() {
    unit_normals_.resize(film_.triangle_rows());
    for (std::uint32_t t = 0; t < film_.triangle_rows(); ++t) {
      if (!film_.alive(Triangle(t))) continue;
      const auto& c = film_.corners(Triangle(t));
      const Vec3 a = film_.position(c[0]);
      const Vec3 n = unit(cross(film_.position(c[1]) - a, film_.position(c[2]) - a));
      unit_normals_[t] = {static_cast<float>(n.x), static_cast<float>(n.y), static_cast<float>(n.z)};
    }
  }

  // Edges across which a film goes on without a crease.
  void find_smooth_edges() {
    smooth_.assign(film_.edge_rows(), 0);
    const auto fixed = film_.columns(film::ElementKind::edge).flags("fixed");
    for (std::uint32_t e = 0; e < film_.edge_rows(); ++e) {
      if (!film_.alive(film::Edge(e)) || !film_.first_side(film::Edge(e)).valid()) continue;
      const Side s = film_.first_side(film::Edge(e));
      const Side across = film_.next_around(s);
      if (across == s || film_.next_around(across) != s) continue;  // a rim or a border
      if (cosine(s, across) < smallest_cosine_) {
        sheets_.creases.emplace_back(e);
      } else if (fixed.empty() || fixed[e] == 0) {
        smooth_[e] = 1;
      }
    }
  }

  // Of the angle at which the film bends between two sides of an edge; 1 where a facet has no direction.
  double cosine(Side s, Side across) const {
    const Point& a = unit_normals_[s.triangle().index];
    const Point& b = unit_normals_[across.triangle().index];
    if (a == Point{} || b == Point{}) return 1;
    const double product = a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    return wound_alike(s, across) ? product : -product;
  }

  // Facets that are wound alike run against each other along their edge.
  bool wound_alike(Side s, Side across) const {
    return film_.edge_of(s).reversed() != film_.edge_of(across).reversed();
  }

  // The next corner of the sheet around the same vertex, beyond the side that leaves the corner (or arrives
  // at it); an invalid triangle at the end of the sheet.
  Corner beyond(const Corner& at, bool leaving) const {
    const Side s(at.triangle, leaving ? at.k : film::previous_corner(at.k));
    if (smooth_[film_.edge_of(s).edge().index] == 0) return {};
    const Side across = film_.next_around(s);
    const bool flips = !wound_alike(s, across);
    const bool leaves_there = leaving == flips;
    const int k = leaves_there ? across.corner() : film::next_corner(across.corner());
    return {across.triangle(), k, at.flipped != flips};
  }

  // All corners of the sheet around the vertex of a corner: first one way round, then the other.
  void gather(const Corner& start) {
    fan_.assign(1, start);
    for (const bool first_way : {true, false}) {
      Corner at = start;
      while (true) {
        // Where the winding flips, so does the direction in which a side leads on.
        at = beyond(at, first_way != at.flipped);
        if (!at.triangle.valid() || sheets_.of_corner[at.row()] != film::no_index) break;
        if (at.triangle == start.triangle && at.k == start.k) {
          finish();
          return;
        }
        fan_.push_back(at);
      }
    }
    finish();
  }

  // Shaded vertices for the corners of the fan. The weights make the normal exact where the corners lie on a
  // sphere.
  void finish() {
    Vec3 sum;
    for (const Corner& corner : fan_) {
      const auto& c = film_.corners(corner.triangle);
      const Vec3 at = film_.position(c[static_cast<std::size_t>(corner.k)]);
      const Vec3 a = film_.position(c[static_cast<std::size_t>(film::next_corner(corner.k))]) - at;
      const Vec3 b = film_.position(c[static_cast<std::size_t>(film::previous_corner(corner.k))]) - at;
      const double weight = length(a) * length(b);
      if (weight > 0) sum += cross(unit(a), unit(b)) / (corner.flipped ? -weight : weight);
    }
    const Vec3 normal = unit(sum);
    std::uint32_t rows[2] = {film::no_index, film::no_index};
    for (const Corner& corner : fan_) {
      std::uint32_t& row = rows[corner.flipped ? 1 : 0];
      if (row == film::no_index) row = add(corner, corner.flipped ? -normal : normal);
      sheets_.of_corner[corner.row()] = row;
    }
  }

  std::uint32_t add(const Corner& corner, const Vec3& n) {
    const film::Vertex v = film_.corners(corner.triangle)[static_cast<std::size_t>(corner.k)];
    sheets_.vertices.push_back(
        {v, {static_cast<float>(n.x), static_cast<float>(n.y), static_cast<float>(n.z)}});
    return static_cast<std::uint32_t>(sheets_.vertices.size() - 1);
  }

  const Film& film_;
  double smallest_cosine_;
  std::vector<Point> unit_normals_;
  std::vector<std::uint8_t> smooth_;  // one an edge row
  std::vector<Corner> fan_;
  Sheets sheets_;
};

}  // namespace

Sheets find_sheets(const Film& film, double crease) {
  return SheetFinder(film, crease).find();
}

}  // namespace lamella::picture
