#include "datafile/write_elements.h"

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <iterator>
#include <vector>

#include <fmt/compile.h>
#include <fmt/format.h>

#include "datafile/attributes.h"
#include "datafile/write_constraints.h"
#include "datafile/write_quantities.h"
#include "scene/constraint_sets.h"
#include "text/error.h"

namespace lamella::datafile {

namespace {

using film::Column;
using film::Edge;
using film::ElementKind;
using film::Film;
using film::Triangle;
using film::Vertex;

void put_number(std::string& out, double value) {
  fmt::format_to(std::back_inserter(out), FMT_COMPILE("{}"), value);
}

void put_id(std::string& out, std::uint32_t id) {
  fmt::format_to(std::back_inserter(out), FMT_COMPILE("{}"), id);
}

bool is_zero(double value) {
  return value == 0 && !std::signbit(value);
}

// The attributes of one kind of element, row by row.
class AttributeWriter {
 public:
  AttributeWriter(ElementKind kind, const film::Columns& columns);

  // `number` is what the element is called in the file, and in messages.
  void write(std::string& out, std::uint32_t row, std::uint32_t number) const;

 private:
  struct Known {
    const KnownColumn* known;
    const Column* column;
  };

  double finite(const Column& column, std::uint32_t row, int component, std::uint32_t number) const;
  void write_known(std::string& out, const Known& known, std::uint32_t row, std::uint32_t number) const;
  void write_colors(std::string& out, std::uint32_t row) const;
  void write_declared(std::string& out, const Column& column, std::uint32_t row, std::uint32_t number) const;
  void write_part(std::string& out, const Column& column, std::uint32_t row, std::uint32_t number,
                  std::size_t dimension, int first, int count) const;

  ElementKind kind_;
  std::vector<Known> known_;
  std::vector<const Column*> declared_;
  const Column* front_ = nullptr;  // of facets
  const Column* back_ = nullptr;
};

// Known columns go in the order of their table, whatever their order in the film.
AttributeWriter::AttributeWriter(ElementKind kind, const film::Columns& columns) : kind_(kind) {
  const bool two_colors = kind == ElementKind::facet;
  for (const KnownColumn& known : known_columns()) {
    const Column* const column = known.kind == kind ? columns.find(known.name) : nullptr;
    if (column == nullptr) continue;
    if (two_colors && known.name == "color") {
      front_ = column;
    } else if (two_colors && known.name == "backcolor") {
      back_ = column;
    } else {
      known_.push_back({&known, column});
    }
  }
  columns.for_each([&](const Column& column) {
    if (is_declared_column(kind, column)) declared_.push_back(&column);
  });
}

double AttributeWriter::finite(const Column& column, std::uint32_t row, int component,
                               std::uint32_t number) const {
  const double value = column.value(row, component);
  if (std::isfinite(value)) return value;
  throw text::Error(
      fmt::format("cannot save: \"{}\" of {} {} is {}", column.name, element_name(kind_), number, value));
}

void AttributeWriter::write_known(std::string& out, const Known& known, std::uint32_t row,
                                  std::uint32_t number) const {
  const double value = finite(*known.column, row, 0, number);
  const double blank = known.known->name == "original" ? number : known.column->blank;
  if (value == blank && std::signbit(value) == std::signbit(blank)) return;
  out += ' ';
  out += known.known->name;
  if (known.known->type == KnownColumn::Type::flag) return;
  out += ' ';
  put_number(out, value);
}

void AttributeWriter::write_colors(std::string& out, std::uint32_t row) const {
  const double white = known_column(ElementKind::facet, "color")->blank;
  const double front = front_ != nullptr ? front_->value(row) : white;
  const double back = back_ != nullptr ? back_->value(row) : front;
  if (front == back && front != white) out += fmt::format(" color {}", front);
  if (front == back) return;
  if (front != white) out += fmt::format(" frontcolor {}", front);
  if (back != white) out += fmt::format(" backcolor {}", back);
}

// Values that are all zero go without saying.
void AttributeWriter::write_declared(std::string& out, const Column& column, std::uint32_t row,
                                     std::uint32_t number) const {
  bool blank = true;
  for (int k = 0; blank && k < column.width; ++k) blank = is_zero(column.value(row, k));
  if (blank) return;
  out += ' ';
  out += column.name;
  out += ' ';
  write_part(out, column, row, number, 0, 0, column.width);
}

void AttributeWriter::write_part(std::string& out, const Column& column, std::uint32_t row,
                                 std::uint32_t number, std::size_t dimension, int first, int count) const {
  if (dimension == column.shape.size()) {
    put_number(out, finite(column, row, first, number));
    return;
  }
  const int parts = column.shape[dimension];
  const int part = count / parts;
  out += '{';
  for (int i = 0; i < parts; ++i) {
    if (i > 0) out += ',';
    write_part(out, column, row, number, dimension + 1, first + i * part, part);
  }
  out += '}';
}

void AttributeWriter::write(std::string& out, std::uint32_t row, std::uint32_t number) const {
  for (const Known& known : known_) write_known(out, known, row, number);
  if (front_ != nullptr || back_ != nullptr) write_colors(out, row);
  for (const Column* column : declared_) write_declared(out, *column, row, number);
}

// --- lists

bool in_plane(const scene::Scene& scene) {
  return scene.strings.on && scene.strings.dimension == 2;
}

// The coordinates of a vertex, or its parameters on its boundary.
void write_place(std::string& out, const scene::Scene& scene, Vertex v) {
  const Film& film = scene.film;
  const auto boundary = scene.boundaries.find(scene::boundary_of(scene, ElementKind::vertex, v.index));
  if (boundary == scene.boundaries.end()) {
    const film::Vec3& position = film.position(v);
    if (!is_finite(position))
      throw text::Error(fmt::format("cannot save: vertex {} is nowhere", film.number(v)));
    fmt::format_to(std::back_inserter(out), FMT_COMPILE("{} {} {}"), film.number(v), position.x, position.y);
    if (!in_plane(scene)) fmt::format_to(std::back_inserter(out), FMT_COMPILE(" {}"), position.z);
    return;
  }
  const std::array<double, 3> parameters = scene::boundary_parameters(scene, v);
  put_id(out, film.number(v));
  for (std::size_t k = 0; k < static_cast<std::size_t>(boundary->second.parameters); ++k) {
    if (!std::isfinite(parameters[k]))
      throw text::Error(fmt::format("cannot save: vertex {} is nowhere", film.number(v)));
    out += ' ';
    put_number(out, parameters[k]);
  }
}

void write_vertices(std::string& out, const scene::Scene& scene) {
  const Film& film = scene.film;
  const ConstraintWriter constraints(scene, ElementKind::vertex);
  const MembershipWriter memberships(scene, ElementKind::vertex);
  const AttributeWriter attributes(ElementKind::vertex, film.columns(ElementKind::vertex));
  out += "vertices\n";
  for (std::uint32_t row = 0; row < film.vertex_rows(); ++row) {
    const Vertex v(row);
    if (!film.alive(v)) continue;
    write_place(out, scene, v);
    constraints.write(out, row);
    memberships.write(out, row);
    attributes.write(out, row, film.number(v));
    out += '\n';
  }
}

// An edge that goes around more than once cannot be written down.
void write_wrap(std::string& out, const scene::Scene& scene, Edge e) {
  const Film& film = scene.film;
  const film::Wrap wrap = film.wrap(film::SignedEdge(e, false));
  for (std::size_t i = 0; i < (in_plane(scene) ? 2U : 3U); ++i) {
    if (std::abs(wrap[i]) > 1) {
      throw text::Error(
          fmt::format("cannot save: edge {} goes around period {} more than once", film.number(e), i + 1));
    }
    out += wrap[i] > 0 ? " +" : wrap[i] < 0 ? " -" : " *";
  }
}

void write_edges(std::string& out, const scene::Scene& scene) {
  const Film& film = scene.film;
  const ConstraintWriter constraints(scene, ElementKind::edge);
  const MembershipWriter memberships(scene, ElementKind::edge);
  const AttributeWriter attributes(ElementKind::edge, film.columns(ElementKind::edge));
  out += "\nedges\n";
  for (std::uint32_t row = 0; row < film.edge_rows(); ++row) {
    const Edge e(row);
    if (!film.alive(e)) continue;
    fmt::format_to(std::back_inserter(out), FMT_COMPILE("{} {} {}"), film.number(e),
                   film.number(film.ends(e)[0]), film.number(film.ends(e)[1]));
    if (film.periodic()) write_wrap(out, scene, e);
    constraints.write(out, row);
    memberships.write(out, row);
    attributes.write(out, row, film.number(e));
    out += '\n';
  }
}

void write_faces(std::string& out, const scene::Scene& scene) {
  const Film& film = scene.film;
  const ConstraintWriter constraints(scene, ElementKind::facet);
  const MembershipWriter memberships(scene, ElementKind::facet);
  const AttributeWriter attributes(ElementKind::facet, film.columns(ElementKind::facet));
  out += "\nfaces\n";
  for (std::uint32_t row = 0; row < film.triangle_rows(); ++row) {
    const Triangle t(row);
    if (!film.alive(t)) continue;
    put_id(out, film.number(t));
    for (const film::SignedEdge e : film.edges(t)) {
      out += e.reversed() ? " -" : " ";
      put_id(out, film.number(e.edge()));
    }
    constraints.write(out, row);
    memberships.write(out, row);
    attributes.write(out, row, film.number(t));
    out += '\n';
  }
}

void write_cells(std::string& out, const scene::Scene& scene) {
  if (scene.strings.cells.empty()) return;
  out += "\nfaces\n";
  const auto loops = scene::loops_of_cells(scene);
  for (std::size_t cell = 0; cell < loops.size(); ++cell) {
    put_id(out, static_cast<std::uint32_t>(cell) + 1);
    for (const film::SignedEdge e : loops[cell]) {
      out += e.reversed() ? " -" : " ";
      put_id(out, scene.film.number(e.edge()));
    }
    out += '\n';
  }
}

// The signed facets of each body, by body row. A facet with a body on both sides is listed with both signs.
std::vector<std::vector<std::int64_t>> facets_of_bodies(const scene::Scene& scene) {
  std::vector<std::vector<std::int64_t>> facets(scene.bodies.size());
  for (std::size_t cell = 0; cell < scene.strings.cells.size(); ++cell) {
    const auto number = static_cast<std::int64_t>(cell) + 1;
    const film::RegionPair regions = scene.strings.cells[cell].regions;
    if (!regions.behind.outside()) facets[regions.behind.index - 1].push_back(number);
    if (!regions.front.outside()) facets[regions.front.index - 1].push_back(-number);
  }
  for (std::uint32_t row = 0; row < scene.film.triangle_rows(); ++row) {
    const Triangle t(row);
    if (!scene.film.alive(t)) continue;
    const auto number = static_cast<std::int64_t>(scene.film.number(t));
    const film::RegionPair regions = scene.film.regions(t);
    if (!regions.behind.outside()) facets[regions.behind.index - 1].push_back(number);
    if (!regions.front.outside()) facets[regions.front.index - 1].push_back(-number);
  }
  return facets;
}

void write_facet_list(std::string& out, const std::vector<std::int64_t>& facets) {
  constexpr std::size_t in_a_line = 10;
  for (std::size_t i = 0; i < facets.size(); ++i) {
    if (i > 0 && i % in_a_line == 0) out += " \\\n ";
    fmt::format_to(std::back_inserter(out), FMT_COMPILE(" {}"), facets[i]);
  }
}

void write_body(std::string& out, const scene::Body& body, std::uint32_t number) {
  const auto put = [&](std::string_view word, double value) {
    if (!std::isfinite(value))
      throw text::Error(fmt::format("cannot save: {} of body {} is {}", word, number, value));
    fmt::format_to(std::back_inserter(out), " {} {}", word, value);
  };
  if (body.target_volume) put("volume", *body.target_volume);
  if (body.fixed_pressure) put("pressure", *body.fixed_pressure);
  if (!body.fixed_pressure && body.pressure != 0) put("lagrange_multiplier", body.pressure);
  if (body.density != 0) put("density", body.density);
  if (body.phase != 0) put("phase", body.phase);
  if (body.volume_offset != 0) put("volconst", body.volume_offset);
  if (body.original != number) put("original", body.original);
  if (body.ramp) {
    fmt::format_to(std::back_inserter(out), " {} {{{},{},{},{}}}", ramp_name, body.ramp->from, body.ramp->to,
                   body.ramp->begin, body.ramp->end);
  }
}

void write_bodies(std::string& out, const scene::Scene& scene) {
  if (body_count(scene) == 0) return;
  const AttributeWriter attributes(ElementKind::body, scene.body_columns);
  const std::vector<std::vector<std::int64_t>> facets = facets_of_bodies(scene);
  out += "\nbodies\n";
  for (std::uint32_t row = 0; row < scene.bodies.size(); ++row) {
    const std::uint32_t number = row + 1;
    if (scene.bodies[row].absent || facets[row].empty()) continue;
    put_id(out, number);
    write_facet_list(out, facets[row]);
    write_body(out, scene.bodies[row], number);
    attributes.write(out, row, number);
    out += '\n';
  }
}

// Bodies that exist and have a facet: one without could not be read.
std::vector<std::uint8_t> bodies_in_use(const scene::Scene& scene) {
  std::vector<std::uint8_t> result(scene.bodies.size() + 1, 0);
  for (const scene::Cell& cell : scene.strings.cells)
    result[cell.regions.front.index] = result[cell.regions.behind.index] = 1;
  for (std::uint32_t row = 0; row < scene.film.triangle_rows(); ++row) {
    if (!scene.film.alive(Triangle(row))) continue;
    const film::RegionPair regions = scene.film.regions(Triangle(row));
    result[regions.front.index] = result[regions.behind.index] = 1;
  }
  result.erase(result.begin());  // the outside
  for (std::uint32_t row = 0; row < scene.bodies.size(); ++row) {
    if (scene.bodies[row].absent) result[row] = 0;
  }
  return result;
}

}  // namespace

// A reader numbers elements and bodies in the order of the file.
bool needs_own_numbers(const scene::Scene& scene) {
  const Film& film = scene.film;
  std::uint32_t next = 1;
  for (std::uint32_t row = 0; row < film.vertex_rows(); ++row) {
    if (film.alive(Vertex(row)) && film.number(Vertex(row)) != next++) return true;
  }
  next = 1;
  for (std::uint32_t row = 0; row < film.edge_rows(); ++row) {
    if (film.alive(Edge(row)) && film.number(Edge(row)) != next++) return true;
  }
  next = 1;
  for (std::uint32_t row = 0; row < film.triangle_rows(); ++row) {
    if (film.alive(Triangle(row)) && film.number(Triangle(row)) != next++) return true;
  }
  next = 1;
  const std::vector<std::uint8_t> used = bodies_in_use(scene);
  for (std::uint32_t row = 0; row < used.size(); ++row) {
    if (used[row] != 0 && row + 1 != next++) return true;
  }
  return false;
}

bool is_declared_column(ElementKind kind, const Column& column) {
  return column.user_defined || carried_column(kind, column.name) != nullptr;
}

void write_elements(std::string& out, const scene::Scene& scene) {
  const std::size_t row_length = 40;
  const std::size_t rows =
      std::size_t{scene.film.vertex_rows()} + scene.film.edge_rows() + scene.film.triangle_rows();
  out.reserve(out.size() + row_length * rows);
  write_vertices(out, scene);
  write_edges(out, scene);
  if (scene.strings.on) {
    write_cells(out, scene);
  } else {
    write_faces(out, scene);
  }
  write_bodies(out, scene);
}

}  // namespace lamella::datafile
