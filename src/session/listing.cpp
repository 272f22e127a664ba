#include "session/listing.h"

#include <fmt/format.h>

#include "datafile/attributes.h"
#include "datafile/write_elements.h"
#include "film/normals.h"
#include "session/element_access.h"

namespace lamella::session {

using film::Column;
using film::Edge;
using film::Triangle;
using film::Vertex;
using language::Element;
using language::ElementKind;

namespace {

// {1, 2} or {{1, 2}, {3, 4}}
std::string braced(const Column& column, std::uint32_t row, std::size_t dimension, int& component) {
  if (dimension == column.shape.size()) return fmt::format("{:.15g}", column.value(row, component++));
  std::string result = "{";
  for (int i = 0; i < column.shape[dimension]; ++i) {
    if (i > 0) result += ", ";
    result += braced(column, row, dimension + 1, component);
  }
  return result + "}";
}

class Lister {
 public:
  Lister(const AttributeSource& source, ElementKind kind) : source_(source), kind_(kind) {}

  std::string line(const Element& element) {
    switch (kind_) {
      case ElementKind::vertex:
        return vertex(Vertex(element.row));
      case ElementKind::edge:
        return edge(Edge(element.row));
      case ElementKind::facet:
        return facet(Triangle(element.row));
      case ElementKind::body:
        return body(element.row);
    }
    return {};
  }

 private:
  const film::Film& film() const { return source_.scene.film; }

  std::string vertex(Vertex v) const {
    const film::Vec3& p = film().position(v);
    const std::uint32_t number = film().number(v);
    return fmt::format("{:3} {:18.15g} {:18.15g} {:18.15g}{}\n", number, p.x, p.y, p.z,
                       attributes(v.index, number));
  }

  std::string edge(Edge e) const {
    const auto& ends = film().ends(e);
    const std::uint32_t number = film().number(e);
    const double length = film::length(film().vector(e));
    return fmt::format("{:3}    {:4} {:4}{}  /*length {:.6g}*/\n", number, film().number(ends[0]),
                       film().number(ends[1]), attributes(e.index, number), length);
  }

  std::string facet(Triangle t) const {
    std::string result = fmt::format("{:3}  ", film().number(t));
    for (const film::SignedEdge e : film().edges(t)) {
      result += fmt::format(" {}{}", e.reversed() ? "-" : "", film().number(e.edge()));
    }
    const double area = film::length(film::double_area_vector(film(), t)) / 2;
    return result + fmt::format("{}  /*area {:.6g}*/\n", attributes(t.index, film().number(t)), area);
  }

  std::string body(std::uint32_t row) {
    constexpr std::size_t facets_a_line = 10;
    std::string result = fmt::format("{:3}  ", row + 1);
    std::size_t count = 0;
    for (const Element& facet : index_.facets_of_body(source_.scene, row)) {
      if (count > 0 && count % facets_a_line == 0) result += " \\\n     ";
      result += fmt::format(" {}{}", facet.reversed ? "-" : "", film().number(Triangle(facet.row)));
      ++count;
    }
    const scene::Body& body = source_.scene.bodies[row];
    if (body.target_volume) result += fmt::format("  volume {:.15g}", *body.target_volume);
    result += fmt::format("  /*actual {:.15g}*/", source_.measures.of(source_.scene).volumes[row + 1]);
    if (body.fixed_pressure) result += fmt::format(" pressure {:.15g}", *body.fixed_pressure);
    if (body.target_volume) result += fmt::format(" lagrange_multiplier {:.15g}", body.pressure);
    if (body.density != 0) result += fmt::format(" density {:.15g}", body.density);
    if (body.phase != 0) result += fmt::format(" phase {}", body.phase);
    if (body.volume_offset != 0) result += fmt::format(" volconst {:.15g}", body.volume_offset);
    if (body.original != row + 1) result += fmt::format(" original {}", body.original);
    return result + attributes(row, row + 1) + "\n";
  }

  std::string attributes(std::uint32_t row, std::uint32_t number) const {
    std::string result;
    const film::Columns& columns = columns_of(static_cast<const scene::Scene&>(source_.scene), kind_);
    columns.for_each([&](const Column& column) {
      const datafile::KnownColumn* const known = datafile::known_column(film_kind(kind_), column.name);
      const bool color =
          kind_ == ElementKind::facet && (column.name == "color" || column.name == "backcolor");
      if (known != nullptr && !color) {
        result += known_attribute(*known, column.value(row), number);
      } else if (known == nullptr && datafile::is_declared_column(film_kind(kind_), column)) {
        int component = 0;
        result += fmt::format(" {} {}", column.name, braced(column, row, 0, component));
      }
    });
    return result + (kind_ == ElementKind::facet ? colors(row) : "");
  }

  static std::string known_attribute(const datafile::KnownColumn& known, double value, std::uint32_t number) {
    const double usual = known.name == "original" ? number : known.blank;
    if (value == usual) return {};
    if (known.type == datafile::KnownColumn::Type::flag) return fmt::format(" {}", known.name);
    return fmt::format(" {} {:.15g}", known.name, value);
  }

  std::string colors(std::uint32_t row) const {
    const film::Columns& columns = film().columns(film::ElementKind::facet);
    const Column* const front_column = columns.find("color");
    const Column* const back_column = columns.find("backcolor");
    const double white = datafile::known_column(film::ElementKind::facet, "color")->blank;
    const double front = front_column != nullptr ? front_column->value(row) : white;
    const double back = back_column != nullptr ? back_column->value(row) : front;
    if (front == back) return front == white ? "" : fmt::format(" color {}", front);
    return fmt::format(" frontcolor {} backcolor {}", front, back);
  }

  const AttributeSource& source_;
  ElementKind kind_;
  ElementIndex index_;
};

std::string_view heading(ElementKind kind) {
  switch (kind) {
    case ElementKind::vertex:
      return "// id                  x                  y                  z\n";
    case ElementKind::edge:
      return "// id    ends\n";
    case ElementKind::facet:
      return "// id  edges\n";
    case ElementKind::body:
      return "// id  facets\n";
  }
  return {};
}

}  // namespace

std::string listing(const AttributeSource& source, const Elements& elements) {
  std::string result(heading(elements.kind));
  Lister lister(source, elements.kind);
  for (const Element& element : elements.list) result += lister.line(element);
  return result;
}

}  // namespace lamella::session
