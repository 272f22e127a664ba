#include "picture/lines.h"

#include <algorithm>
#include <cmath>

namespace lamella::picture {

using film::Edge;
using film::ElementKind;
using film::Film;
using film::Side;
using film::Vertex;

namespace {

bool has_flag(const Film& film, ElementKind kind, std::string_view name, std::uint32_t row) {
  const auto flags = film.columns(kind).flags(name);
  return !flags.empty() && flags[row] != 0;
}

bool inside_fixed_patch(const Film& film, Edge e) {
  bool all_fixed = true;
  film.for_each_side(e, [&](Side s) {
    all_fixed = all_fixed && has_flag(film, ElementKind::facet, "fixed", s.triangle().index);
  });
  return all_fixed;
}

bool ends_fixed(const Film& film, Edge e) {
  return has_flag(film, ElementKind::vertex, "fixed", film.ends(e)[0].index) &&
         has_flag(film, ElementKind::vertex, "fixed", film.ends(e)[1].index);
}

// How much thinner than in a scene of one bubble the borders have to be: a foam's cells, about as wide as
// their area over the length of their borders, must not be crowded out by them.
double thinning(const Drawing& drawing, double border_length) {
  if (border_length <= 0) return 1;
  double area = 0;
  for (const auto& t : drawing.triangles) {
    const auto at = [&](std::size_t k) {
      const Point& p = drawing.positions[t[k]];
      return film::Vec3{p[0], p[1], p[2]};
    };
    area += length(cross(at(1) - at(0), at(2) - at(0))) / 2;
  }
  constexpr double roomy = 0.7;
  return std::clamp(std::sqrt(area / border_length / roomy), 0.4, 1.0);
}

class LineCollector {
 public:
  LineCollector(Drawing& drawing, const Film& film, const Style& style, std::span<const std::uint8_t> facets)
      : drawing_(drawing),
        film_(film),
        style_(style),
        facets_(facets),
        colours_(film.columns(ElementKind::edge).find("color")) {}

  void collect(std::span<const Edge> creases) {
    borders_at_.assign(film_.vertex_rows(), 0);
    double border_length = 0;
    kinds_.resize(film_.edge_rows(), LineKind::none);
    for (std::uint32_t e = 0; e < film_.edge_rows(); ++e) {
      if (!film_.alive(Edge(e)) || !is_drawn(Edge(e))) continue;
      kinds_[e] = line_kind(film_, Edge(e));
      if (kinds_[e] != LineKind::border) continue;
      const auto& [tail, head] = film_.ends(Edge(e));
      border_length += length(film_.position(head) - film_.position(tail)) / drawing_.radius;
      for (const Vertex v : {tail, head}) ++borders_at_[v.index];
    }
    thinning_ = thinning(drawing_, border_length);
    for (const Edge e : creases) {
      if (kinds_[e.index] == LineKind::none && is_drawn(e)) kinds_[e.index] = LineKind::crease;
    }
    const double mesh_radius = style_.mesh.radius > 0 ? thin_enough(style_.mesh.radius) : 0;
    for (std::uint32_t e = 0; e < film_.edge_rows(); ++e) add(Edge(e), mesh_radius);
    for (std::uint32_t v = 0; v < film_.vertex_rows(); ++v) {
      if (borders_at_[v] >= 4) add_quad_point(Vertex(v));
    }
  }

 private:
  bool is_drawn(Edge e) const {
    if (facets_.empty() || !film_.first_side(e).valid()) return true;
    bool any = false;
    film_.for_each_side(e, [&](Side s) { any = any || facets_[s.triangle().index] != 0; });
    return any;
  }

  // Lines of a fine mesh must leave something to be seen of its facets.
  double thin_enough(double radius) const {
    if (drawing_.triangles.empty()) return radius;
    double length_sum = 0;
    for (const auto& t : drawing_.triangles) {
      const Point& a = drawing_.positions[t[0]];
      const Point& b = drawing_.positions[t[1]];
      length_sum += std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
    }
    return std::min(radius, 0.03 * length_sum / static_cast<double>(drawing_.triangles.size()));
  }

  void add(Edge e, double mesh_radius) {
    switch (kinds_[e.index]) {
      case LineKind::none:
      case LineKind::mesh:
        if (mesh_radius > 0 && film_.alive(e) && is_drawn(e)) add(e, style_.mesh, mesh_radius);
        break;
      case LineKind::crease:
        add(e, style_.crease, style_.crease.radius * thinning_);
        break;
      case LineKind::border:
        add(e, style_.border, style_.border.radius * thinning_);
        break;
      case LineKind::rim:
        add(e, style_.rim, style_.rim.radius * thinning_);
        break;
      case LineKind::wire:
        add(e, style_.wire, style_.wire.radius);
        break;
    }
  }

  void add(Edge e, const LineStyle& line, double radius) {
    Colour colour = line.colour;
    if (colours_ != nullptr) {
      const int number = static_cast<int>(colours_->value(e.index));
      if (number == evolver_clear) return;
      if (number != evolver_black) colour = evolver_colour(number);
    }
    const auto& [tail, head] = film_.ends(e);
    const LineKind kind = kinds_[e.index] == LineKind::none ? LineKind::mesh : kinds_[e.index];
    drawing_.tubes.push_back({drawing_.place(film_.position(tail)), static_cast<float>(radius),
                              drawing_.place(film_.position(head)), static_cast<float>(line.gloss), colour,
                              kind});
  }

  void add_quad_point(Vertex v) {
    const Point at = drawing_.place(film_.position(v));
    const double radius = style_.border.radius * thinning_ * style_.quad_point;
    drawing_.tubes.push_back({at, static_cast<float>(radius), at, static_cast<float>(style_.border.gloss),
                              style_.border.colour, LineKind::border});
  }

  Drawing& drawing_;
  const Film& film_;
  const Style& style_;
  std::span<const std::uint8_t> facets_;
  const film::Column* colours_;
  std::vector<LineKind> kinds_;
  std::vector<std::uint32_t> borders_at_;
  double thinning_ = 1;
};

}  // namespace

LineKind line_kind(const Film& film, Edge e) {
  const int sides = film.valence(e);
  if (sides == 0) return LineKind::wire;
  if (has_flag(film, ElementKind::edge, "fixed", e.index)) {
    return sides == 2 && inside_fixed_patch(film, e) ? LineKind::none : LineKind::wire;
  }
  if (sides == 1) return ends_fixed(film, e) ? LineKind::wire : LineKind::rim;
  return sides == 2 ? LineKind::none : LineKind::border;
}

void add_lines(Drawing& drawing, const Film& film, std::span<const Edge> creases, const Style& style,
               std::span<const std::uint8_t> facets) {
  LineCollector(drawing, film, style, facets).collect(creases);
}

}  // namespace lamella::picture
