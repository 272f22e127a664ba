#include "picture/drawing.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "picture/clip.h"
#include "picture/explode.h"
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

// A facet's colours: those of a field, of its regions, of its columns or of the style. Without a column for
// the back it looks like the front.
Colour field_colour(const ColourField& field, double value) {
  const double range = field.high - field.low;
  return colour_of(field.map, range > 0 ? (value - field.low) / range : 0.5);
}

class FacetColours {
 public:
  FacetColours(const Film& film, const Style& style, const std::optional<ColourField>& field)
      : film_(film),
        style_(style.film),
        front_(film.columns(ElementKind::facet).find("color")),
        behind_(film.columns(ElementKind::facet).find("backcolor")) {
    if (behind_ == nullptr) behind_ = front_;
    if (field && field->of == ElementKind::facet) field_ = &*field;
    by_vertex_ = field && field_ == nullptr;
  }

  bool any() const {
    return !by_vertex_ &&
           (field_ != nullptr || front_ != nullptr || behind_ != nullptr || style_.by_region || style_.paint);
  }
  bool hidden(Triangle t) const {
    return number(front_, t) == evolver_clear && number(behind_, t) == evolver_clear;
  }

  Tint tint(Triangle t) const {
    Tint tint;
    if (field_ != nullptr) {
      const double value = field_->values[t.index];
      if (value == value) tint = both(field_colour(*field_, value));
      return tint;
    }
    if (style_.paint) tint = both(*style_.paint);
    if (style_.by_region) return by_region(tint, film_.regions(t));
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

  static Tint both(const Colour& colour) { return {colour, 1, colour, 1}; }

  // From outside a bubble has its own colour, from within a film that of the bubble beyond it.
  static Tint by_region(Tint tint, film::RegionPair regions) {
    const film::Region front = !regions.behind.outside() ? regions.behind : regions.front;
    const film::Region behind = !regions.front.outside() ? regions.front : regions.behind;
    if (!front.outside()) tint.front = region_colour(front);
    if (!behind.outside()) tint.behind = region_colour(behind);
    return tint;
  }

  const Film& film_;
  const FilmStyle& style_;
  const ColourField* field_ = nullptr;
  bool by_vertex_ = false;
  const film::Column* front_;
  const film::Column* behind_;
};

void add_film(Drawing& drawing, const Film& film, const Sheets& sheets, const Style& style,
              const Content& content) {
  drawing.positions.reserve(sheets.vertices.size());
  drawing.normals.reserve(sheets.vertices.size());
  for (const Sheets::ShadedVertex& shaded : sheets.vertices) {
    drawing.positions.push_back(drawing.place(film.position(shaded.vertex)));
    drawing.normals.push_back(shaded.normal);
  }
  const FacetColours colours(film, style, content.field);
  const auto undisplayed = film.columns(ElementKind::facet).flags("nodisplay");
  drawing.triangles.reserve(film.triangle_count());
  drawing.regions.reserve(film.triangle_count());
  for (std::uint32_t t = 0; t < film.triangle_rows(); ++t) {
    if (!film.alive(Triangle(t)) || colours.hidden(Triangle(t))) continue;
    if (!undisplayed.empty() && undisplayed[t] != 0) continue;
    if (!content.facets.empty() && content.facets[t] == 0) continue;
    const std::size_t corner = 3 * std::size_t{t};
    drawing.triangles.push_back(
        {sheets.of_corner[corner], sheets.of_corner[corner + 1], sheets.of_corner[corner + 2]});
    drawing.regions.push_back(film.regions(Triangle(t)));
    if (colours.any()) drawing.tints.push_back(colours.tint(Triangle(t)));
  }
}

void add_vertex_tints(Drawing& drawing, const Sheets& sheets, const ColourField& field) {
  drawing.vertex_tints.reserve(sheets.vertices.size());
  for (const Sheets::ShadedVertex& shaded : sheets.vertices) {
    const double value = field.values[shaded.vertex.index];
    drawing.vertex_tints.push_back(value == value ? VertexTint{field_colour(field, value), 1} : VertexTint{});
  }
}

// A film that drains under its own weight is a parabola in profile: its thickness grows as the root of the
// depth (Mysels, Shinoda and Frankel, "Soap Films", 1959).
void add_thickness(Drawing& drawing, const Sheets& sheets, const FilmStyle& style,
                   const std::vector<double>& given) {
  drawing.thickness.reserve(sheets.vertices.size());
  if (!given.empty()) {
    for (const auto& shaded : sheets.vertices)
      drawing.thickness.push_back(static_cast<float>(given[shaded.vertex.index]));
    return;
  }
  float low = std::numeric_limits<float>::max();
  float high = std::numeric_limits<float>::lowest();
  for (const Point& p : drawing.positions) {
    low = std::min(low, p[2]);
    high = std::max(high, p[2]);
  }
  const auto top = static_cast<float>(style.thickness_top);
  const auto more = static_cast<float>(style.thickness_bottom - style.thickness_top);
  for (const Point& p : drawing.positions) {
    const float depth = high > low ? (high - p[2]) / (high - low) : 0;
    drawing.thickness.push_back(top + more * std::sqrt(depth));
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

Colour region_colour(film::Region region) {
  return distinct_colour(region.index - 1);
}

Drawing draw(const scene::Scene& scene, const Style& style, const Content& content) {
  if (content.explode > 0) {
    const FilmCopy exploded = explode(scene, content);
    return draw(exploded.scene, style, exploded.content);
  }
  Drawing drawing;
  measure(drawing, scene.film);
  if (content.surrounding) {
    drawing.middle = content.surrounding->middle;
    drawing.radius = content.surrounding->radius;
  }
  const Sheets sheets = find_sheets(scene.film, style.crease_angle);
  add_film(drawing, scene.film, sheets, style, content);
  measure_bends(drawing);
  add_thickness(drawing, sheets, style.film, content.thickness);
  if (content.field && content.field->of == ElementKind::vertex)
    add_vertex_tints(drawing, sheets, *content.field);
  add_lines(drawing, scene.film, sheets.creases, style, content.facets);
  if (content.clip) clip(drawing, *content.clip);
  if (content.clip || !content.facets.empty()) drop_unused_vertices(drawing);
  return drawing;
}

}  // namespace lamella::picture
