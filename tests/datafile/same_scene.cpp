#include "datafile/same_scene.h"

#include <cstring>
#include <set>

#include <fmt/format.h>

#include "datafile/attributes.h"

namespace lamella::test {

namespace {

using film::ElementKind;
using film::Film;

bool same_bits(double a, double b) {
  return std::memcmp(&a, &b, sizeof a) == 0;
}

bool same_bits(const film::Vec3& a, const film::Vec3& b) {
  return same_bits(a.x, b.x) && same_bits(a.y, b.y) && same_bits(a.z, b.z);
}

// The rows of a film that are alive, in order.
struct Live {
  std::vector<film::Vertex> vertices;
  std::vector<film::Edge> edges;
  std::vector<film::Triangle> triangles;

  explicit Live(const Film& film) {
    for (std::uint32_t i = 0; i < film.vertex_rows(); ++i) {
      if (film.alive(film::Vertex(i))) vertices.emplace_back(i);
    }
    for (std::uint32_t i = 0; i < film.edge_rows(); ++i) {
      if (film.alive(film::Edge(i))) edges.emplace_back(i);
    }
    for (std::uint32_t i = 0; i < film.triangle_rows(); ++i) {
      if (film.alive(film::Triangle(i))) triangles.emplace_back(i);
    }
  }
};

std::string film_difference(const Film& a, const Film& b) {
  const Live x(a);
  const Live y(b);
  if (x.vertices.size() != y.vertices.size()) return "the number of vertices";
  if (x.edges.size() != y.edges.size()) return "the number of edges";
  if (x.triangles.size() != y.triangles.size()) return "the number of facets";
  for (std::size_t i = 0; i < x.vertices.size(); ++i) {
    const auto v = x.vertices[i];
    const auto w = y.vertices[i];
    if (a.number(v) != b.number(w)) return fmt::format("the number of vertex row {}", i);
    if (!same_bits(a.position(v), b.position(w))) return fmt::format("the position of vertex row {}", i);
  }
  for (std::size_t i = 0; i < x.edges.size(); ++i) {
    const auto e = x.edges[i];
    const auto f = y.edges[i];
    if (a.number(e) != b.number(f)) return fmt::format("the number of edge row {}", i);
    for (std::size_t end = 0; end < 2; ++end) {
      if (a.number(a.ends(e)[end]) != b.number(b.ends(f)[end]))
        return fmt::format("an end of edge row {}", i);
    }
  }
  for (std::size_t i = 0; i < x.triangles.size(); ++i) {
    const auto t = x.triangles[i];
    const auto u = y.triangles[i];
    if (a.number(t) != b.number(u)) return fmt::format("the number of facet row {}", i);
    if (!(a.regions(t) == b.regions(u))) return fmt::format("the regions of facet row {}", i);
    for (std::size_t k = 0; k < 3; ++k) {
      const auto e = a.edges(t)[k];
      const auto f = b.edges(u)[k];
      if (a.number(e.edge()) != b.number(f.edge()) || e.reversed() != f.reversed()) {
        return fmt::format("edge {} of facet row {}", k, i);
      }
    }
  }
  return {};
}

bool is_kept(ElementKind kind, const film::Column& column) {
  // Parameters on boundaries show in the positions.
  return column.name == scene::constraint_column || column.name == scene::boundary_column ||
         column.user_defined || datafile::known_column(kind, column.name) != nullptr ||
         datafile::carried_column(kind, column.name) != nullptr;
}

// What an element has of a column: its blank value where the film has no such column.
double value(const film::Columns& columns, const film::Column& like, std::uint32_t row, int component) {
  const film::Column* column = columns.find(like.name);
  if (column == nullptr && like.name == "backcolor") column = columns.find("color");
  return column != nullptr ? column->value(row, component) : like.blank;
}

std::string declaration_difference(const film::Column& a, const film::Column& b) {
  if (a.shape != b.shape || a.width != b.width) return "its shape";
  if (a.user_defined != b.user_defined) return "who declared it";
  if (a.data.index() != b.data.index()) return "its kind of number";
  if (a.inheritance.on_new != b.inheritance.on_new) return "what new elements inherit";
  if (a.inheritance.on_merge != b.inheritance.on_merge) return "what merged elements inherit";
  return same_bits(a.blank, b.blank) ? std::string{} : "its blank value";
}

template <class Ids>
std::string columns_difference(ElementKind kind, const film::Columns& a, const film::Columns& b, const Ids& x,
                               const Ids& y) {
  std::string found;
  const auto compare = [&](const film::Column& like) {
    if (!found.empty() || !is_kept(kind, like)) return;
    const film::Column* other = (&like == a.find(like.name) ? b : a).find(like.name);
    std::string what;
    if (other != nullptr) what = declaration_difference(like, *other);
    if (other == nullptr && like.user_defined) what = "whether there is one";
    for (std::size_t i = 0; what.empty() && i < x.size(); ++i) {
      for (int k = 0; k < like.width; ++k) {
        if (!same_bits(value(a, like, x[i].index, k), value(b, like, y[i].index, k)))
          what = fmt::format("row {}", i);
      }
    }
    if (!what.empty()) found = fmt::format("{} column {}: {}", film::name_of(kind), like.name, what);
  };
  a.for_each(compare);
  b.for_each(compare);
  return found;
}

std::string body_difference(const scene::Body& a, const scene::Body& b) {
  if (a.absent != b.absent) return "whether it exists";
  if (a.absent) return {};
  if (a.original != b.original) return "its original number";
  if (a.target_volume != b.target_volume) return "its target";
  if (a.fixed_pressure != b.fixed_pressure) return "its fixed pressure";
  if (!same_bits(a.pressure, b.pressure)) return "its pressure";
  if (!same_bits(a.density, b.density)) return "its density";
  if (!same_bits(a.volume_offset, b.volume_offset)) return "its volume constant";
  if (a.ramp.has_value() != b.ramp.has_value()) return "whether its target moves";
  const bool same_ramp = !a.ramp || (a.ramp->from == b.ramp->from && a.ramp->to == b.ramp->to &&
                                     a.ramp->begin == b.ramp->begin && a.ramp->end == b.ramp->end);
  return same_ramp ? std::string{} : "how its target moves";
}

std::string texts(const std::array<language::Formula, 3>& components) {
  return fmt::format("{} | {} | {}", components[0].text(), components[1].text(), components[2].text());
}

template <class Set>
std::string integrals(const Set& set) {
  return fmt::format("energy {} content {}", set.energy ? texts(*set.energy) : "",
                     set.content ? texts(*set.content) : "");
}

std::string constraints_of(const scene::Scene& scene) {
  std::string all =
      fmt::format("{} {} {}\n", scene.gap_constant,
                  100 * scene.edge_integral_order + scene.facet_integral_order, scene.interpolate_parameters);
  for (const auto& [number, set] : scene.level_sets) {
    all += fmt::format("constraint {} {} {} {} {} {} {} {}\n", number, set.name, static_cast<int>(set.sense),
                       set.global, set.convex, set.nonwall, set.formula.text(), integrals(set));
  }
  for (const auto& [number, boundary] : scene.boundaries) {
    all += fmt::format("boundary {} {} {} {} {} {}\n", number, boundary.name, boundary.parameters,
                       boundary.convex, texts(boundary.position), integrals(boundary));
  }
  return all;
}

std::string bodies_difference(const scene::Scene& a, const scene::Scene& b) {
  if (a.bodies.size() != b.bodies.size()) return "the number of bodies";
  std::vector<film::Vertex> rows;  // any id will do
  for (std::uint32_t i = 0; i < a.bodies.size(); ++i) {
    const std::string what = body_difference(a.bodies[i], b.bodies[i]);
    if (!what.empty()) return fmt::format("body {}: {}", i + 1, what);
    if (!a.bodies[i].absent) rows.emplace_back(i);
  }
  return columns_difference(ElementKind::body, a.body_columns, b.body_columns, rows, rows);
}

std::string settings_difference(const scene::Scene& a, const scene::Scene& b) {
  if (!same_bits(a.gravity.constant, b.gravity.constant)) return "the gravity constant";
  if (!same_bits(a.scale.value, b.scale.value) || a.scale.fixed != b.scale.fixed) return "the scale";
  if (!same_bits(a.scale.limit, b.scale.limit)) return "the limit of the scale";
  if (a.keep_volumes != b.keep_volumes) return "whether volumes are kept";
  if (a.symmetric_content != b.symmetric_content) return "how volumes are measured";
  if (!same_bits(a.time, b.time)) return "the time";
  if (!same_bits(a.damping, b.damping)) return "the damping";
  if (a.title != b.title) return "the title";
  if (a.cosmetics.size() != b.cosmetics.size()) return "the number of cosmetic lines";
  for (std::size_t i = 0; i < a.cosmetics.size(); ++i) {
    if (a.cosmetics[i].keyword != b.cosmetics[i].keyword || a.cosmetics[i].text != b.cosmetics[i].text) {
      return fmt::format("the cosmetic line {}", a.cosmetics[i].keyword);
    }
  }
  return {};
}

using NamedValue = std::pair<std::string, language::Value>;

std::vector<NamedValue> parameters(const scene::Scene& scene) {
  std::vector<NamedValue> result;
  scene.variables.for_each([&](language::VariableId id, const language::Variable& variable) {
    if (variable.parameter) result.emplace_back(scene.variables.name(id), variable.value);
  });
  return result;
}

}  // namespace

std::string first_difference(const scene::Scene& a, const scene::Scene& b) {
  std::string found = film_difference(a.film, b.film);
  if (!found.empty()) return found;
  const Live x(a.film);
  const Live y(b.film);
  for (const ElementKind kind : {ElementKind::vertex, ElementKind::edge, ElementKind::facet}) {
    const auto compare = [&](const auto& rows_a, const auto& rows_b) {
      return columns_difference(kind, a.film.columns(kind), b.film.columns(kind), rows_a, rows_b);
    };
    found = kind == ElementKind::vertex ? compare(x.vertices, y.vertices)
            : kind == ElementKind::edge ? compare(x.edges, y.edges)
                                        : compare(x.triangles, y.triangles);
    if (!found.empty()) return found;
  }
  if (constraints_of(a) != constraints_of(b)) return "constraints or boundaries";
  found = bodies_difference(a, b);
  if (found.empty()) found = settings_difference(a, b);
  if (found.empty() && parameters(a) != parameters(b)) found = "the parameters";
  return found;
}

}  // namespace lamella::test
