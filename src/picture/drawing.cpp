#include "picture/drawing.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "picture/lines.h"
#include "picture/sheets.h"
#include "text/error.h"

namespace lamella::picture {

using film::ElementKind;
using film::Film;
using film::Triangle;
using film::Vec3;

namespace {

// Squares of lengths beyond this are no numbers any more.
constexpr double largest_radius = 1e150;

// The box of all vertices that an edge ends at decides the unit of length.
void measure(Drawing& drawing, const Film& film) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Vec3 low{infinity, infinity, infinity};
  Vec3 high = -low;
  for (std::uint32_t v = 0; v < film.vertex_rows(); ++v) {
    const film::EdgeEnd end = film.first_end(film::Vertex(v));
    if (!end.valid() || end == film::dead_vertex) continue;
    const Vec3 p = film.position(film::Vertex(v));
    if (!is_finite(p)) {
      throw text::Error(
          fmt::format("vertex {} is at no place: ({}, {}, {})", film.number(film::Vertex(v)), p.x, p.y, p.z),
          "a scene can be drawn when all coordinates are finite; undo may lead back to such a scene");
    }
    for (int k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], p[k]);
      high[k] = std::max(high[k], p[k]);
    }
  }
  if (low.x > high.x) return;  // nothing to draw
  drawing.middle = low / 2 + high / 2;
  const Vec3 half = high / 2 - low / 2;
  const double radius = std::hypot(half.x, half.y, half.z);
  if (!(radius < largest_radius)) {
    throw text::Error(fmt::format("the scene is {:.3g} wide, too large to be drawn", 2 * radius),
                      fmt::format("distances up to {:.0e} can be drawn", largest_radius));
  }
  if (radius > 0) drawing.radius = radius;
}

// What the columns say of a facet's colours. Without a column for the back it looks like the front.
class FacetColours {
 public:
  explicit FacetColours(const Film& film)
      : front_(film.columns(ElementKind::facet).find("color")),
        behind_(film.columns(ElementKind::facet).find("backcolor")) {
    if (behind_ == nullptr) behind_ = front_;
  }

  bool any() const { return front_ != nullptr || behind_ != nullptr; }
  bool hidden(Triangle t) const {
    return number(front_, t) == evolver_clear && number(behind_, t) == evolver_clear;
  }

  Tint tint(Triangle t) const {
    Tint tint;
    set(number(front_, t), tint.front, tint.front_strength);
    set(number(behind_, t), tint.behind, tint.behind_strength);
    return tint;
  }

 private:
  static int number(const film::Column* column, Triangle t) {
    return column != nullptr ? static_cast<int>(column->value(t.index)) : evolver_white;
  }

  static void set(int number, Colour& colour, float& strength) {
    if (number == evolver_white || number == evolver_clear) return;
    colour = evolver_colour(number);
    strength = 1;
  }

  const film::Column* front_;
  const film::Column* behind_;
};

void add_film(Drawing& drawing, const Film& film, const Sheets& sheets) {
  drawing.positions.reserve(sheets.vertices.size());
  drawing.normals.reserve(sheets.vertices.size());
  for (const Sheets::ShadedVertex& shaded : sheets.vertices) {
    drawing.positions.push_back(drawing.place(film.position(shaded.vertex)));
    drawing.normals.push_back(shaded.normal);
  }
  const FacetColours colours(film);
  const auto undisplayed = film.columns(ElementKind::facet).flags("nodisplay");
  drawing.triangles.reserve(film.triangle_count());
  for (std::uint32_t t = 0; t < film.triangle_rows(); ++t) {
    if (!film.alive(Triangle(t)) || colours.hidden(Triangle(t))) continue;
    if (!undisplayed.empty() && undisplayed[t] != 0) continue;
    const std::size_t corner = 3 * std::size_t{t};
    drawing.triangles.push_back(
        {sheets.of_corner[corner], sheets.of_corner[corner + 1], sheets.of_corner[corner + 2]});
    if (colours.any()) drawing.tints.push_back(colours.tint(Triangle(t)));
  }
}

// Means over the edges at each vertex of a quantity of an edge's two ends.
template <class Quantity>
std::vector<float> mean_over_edges(const Drawing& drawing, Quantity&& quantity) {
  std::vector<float> sums(drawing.positions.size(), 0);
  std::vector<float> counts(drawing.positions.size(), 0);
  for (const auto& t : drawing.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = t[k];
      const std::uint32_t b = t[(k + 1) % 3];
      const float value = quantity(a, b);
      sums[a] += value;
      sums[b] += value;
      counts[a] += 1;
      counts[b] += 1;
    }
  }
  for (std::size_t v = 0; v < sums.size(); ++v) sums[v] /= std::max(counts[v], 1.0F);
  return sums;
}

float distance(const Point& a, const Point& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

// The turn of the normal along an edge over its length, smoothed a little: normals of a coarse mesh are
// uneven.
void measure_bends(Drawing& drawing) {
  drawing.bends = mean_over_edges(drawing, [&](std::uint32_t a, std::uint32_t b) {
    const float edge = distance(drawing.positions[a], drawing.positions[b]);
    return edge > 0 ? std::min(distance(drawing.normals[a], drawing.normals[b]) / edge, 4.0F) : 0.0F;
  });
  constexpr int rounds = 2;
  for (int i = 0; i < rounds; ++i) {
    const std::vector<float> before = std::move(drawing.bends);
    drawing.bends = mean_over_edges(
        drawing, [&](std::uint32_t a, std::uint32_t b) { return (before[a] + before[b]) / 2; });
  }
}

}  // namespace

double Drawing::largest_tube() const {
  float largest = 0;
  for (const Tube& tube : tubes) largest = std::max(largest, tube.radius);
  return largest;
}

Point Drawing::place(const Vec3& p) const {
  const Vec3 q = (p - middle) / radius;
  return {static_cast<float>(q.x), static_cast<float>(q.y), static_cast<float>(q.z)};
}

std::vector<Point> Drawing::outline() const {
  std::vector<Point> points = positions;
  points.reserve(positions.size() + 2 * tubes.size());
  for (const Tube& tube : tubes) {
    points.push_back(tube.from);
    points.push_back(tube.to);
  }
  return points;
}

Drawing draw(const scene::Scene& scene, const Style& style) {
  Drawing drawing;
  measure(drawing, scene.film);
  const Sheets sheets = find_sheets(scene.film, style.crease_angle);
  add_film(drawing, scene.film, sheets);
  measure_bends(drawing);
  add_lines(drawing, scene.film, sheets.creases, style);
  return drawing;
}

}  // namespace lamella::picture
