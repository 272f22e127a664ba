#include "session/attribute_table.h"

#include <cmath>

#include <fmt/format.h>

#include "datafile/attributes.h"
#include "film/normals.h"
#include "film/vertex_place.h"
#include "session/constraint_attributes.h"
#include "session/element_access.h"
#include "text/error.h"

namespace lamella::session {

using film::Edge;
using film::Region;
using film::Side;
using film::Triangle;
using film::Vec3;
using film::Vertex;
using language::Element;
using language::ElementKind;
using Source = AttributeSource;

film::Column& made_column(const Source& source, ElementKind kind, const std::string& name) {
  film::Columns& columns = columns_of(source.scene, kind);
  if (film::Column* const existing = columns.edit(name)) return *existing;
  return columns.add(datafile::make_column(*datafile::known_column(film_kind(kind), name)));
}

double column_value(const Source& source, const Element& element, const std::string& name, int component) {
  if (const film::Column* const column = columns_of(source.scene, element.kind).find(name)) {
    return column->value(element.row, component);
  }
  const datafile::KnownColumn* const known = datafile::known_column(film_kind(element.kind), name);
  return known != nullptr ? known->blank : 0;
}

double checked_color(double value) {
  constexpr double most = 255;
  if (value != std::floor(value) || value < -1 || value > most) {
    throw text::Error(fmt::format("{:.15g} is no color", value),
                      "colors are -1 (clear) to 15 (white), and have names: red, blue");
  }
  return value;
}

namespace {

double sign(const Element& element) {
  return element.reversed ? -1 : 1;
}

// --- vertices

double coordinate(const Source& source, const Element& v, int axis) {
  return source.scene.film.position(Vertex(v.row))[axis];
}

void set_coordinate(const Source& source, const Element& v, int axis, double value) {
  if (!std::isfinite(value)) throw text::Error(fmt::format("a coordinate cannot be {}", value));
  source.scene.film.edit_positions()[v.row][axis] = value;
}

template <int axis>
double coordinate_on(const Source& source, const Element& v, int) {
  return coordinate(source, v, axis);
}
template <int axis>
void set_coordinate_on(const Source& source, const Element& v, int, double value) {
  set_coordinate(source, v, axis, value);
}

// What evolve keeps; a film that has never moved has no such column.
double velocity(const Source& source, const Element& v, int axis) {
  const film::Column* const column = source.scene.film.columns(film::ElementKind::vertex).find("velocity");
  return column != nullptr ? column->value(v.row, axis) : 0;
}

void set_velocity(const Source& source, const Element& v, int axis, double value) {
  if (!std::isfinite(value)) throw text::Error(fmt::format("a velocity cannot be {}", value));
  film::Columns& columns = source.scene.film.columns(film::ElementKind::vertex);
  film::Column* column = columns.edit("velocity");
  if (column == nullptr)
    column = &columns.add(film::real_column("velocity", 0, 3, film::Inheritance::New::mean));
  column->set(v.row, axis, value);
}

// --- edges

Vec3 edge_vector(const Source& source, const Element& e) {
  return source.scene.film.vector(Edge(e.row)) * sign(e);
}

template <int axis>
double edge_component(const Source& source, const Element& e, int) {
  return edge_vector(source, e)[axis];
}

double edge_length(const Source& source, const Element& e, int) {
  return film::length(edge_vector(source, e));
}

// --- facets

// Half the cross product of two edges: the normal, as long as the facet is large.
Vec3 area_vector(const Source& source, const Element& f) {
  const film::Film& film = source.scene.film;
  return film::double_area_vector(film, Triangle(f.row)) * (0.5 * sign(f));
}

template <int axis>
double facet_component(const Source& source, const Element& f, int) {
  return area_vector(source, f)[axis];
}

double facet_area(const Source& source, const Element& f, int) {
  return film::length(area_vector(source, f));
}

// The angle between the normals of the two facets at an edge, seen as one surface; 0 elsewhere.
double dihedral(const Source& source, const Element& e, int) {
  const film::Film& film = source.scene.film;
  const Side first = film.first_side(Edge(e.row));
  if (film.valence(Edge(e.row)) != 2) return 0;
  const Side second = film.next_around(first);
  const bool same_way = film.edge_of(first) != film.edge_of(second);
  const Vec3 a = area_vector(source, {ElementKind::facet, first.triangle().index, false});
  const Vec3 b = area_vector(source, {ElementKind::facet, second.triangle().index, !same_way});
  return film::angle_between(a, b);
}

// Half of how fast the area around a vertex grows with the volume under it: 1/r on a sphere whose normals
// point outward. 0 where films meet or end.
double mean_curvature(const Source& source, const Element& v, int) {
  const film::Film& film = source.scene.film;
  const film::Vertex vertex(v.row);
  if (film::place_of(film, vertex).kind != film::PlaceKind::inside) return 0;
  Vec3 growth;
  Vec3 normal;
  film.for_each_end(vertex, [&](film::EdgeEnd end) {
    film.for_each_side(end.edge(), [&](Side s) {
      const auto k = static_cast<std::size_t>(s.corner());
      // Of a facet's two edges here, the one that runs away from the vertex counts.
      if (film.corners(s.triangle())[k] != vertex) return;
      const std::array<Vec3, 3> p = film.points(s.triangle());
      const Vec3 q = p[(k + 1) % 3] - p[k];
      const Vec3 r = p[(k + 2) % 3] - p[k];
      const Vec3 area = cross(q, r) / 2;
      growth += cross(unit(area), r - q) / 2;
      // Facets of one film may be wound either way.
      normal += (dot(area, normal) < 0 ? -1.0 / 3 : 1.0 / 3) * area;
    });
  });
  return dot(normal, normal) > 0 ? dot(growth, normal) / (2 * dot(normal, normal)) : 0;
}

film::RegionPair regions(const Source& source, const Element& f) {
  const film::RegionPair pair = source.scene.film.regions(Triangle(f.row));
  return f.reversed ? pair.flipped() : pair;
}

Region region_numbered(const Source& source, double number) {
  const auto count = static_cast<double>(source.scene.bodies.size());
  if (number != std::floor(number) || number < 0 || number > count) {
    throw text::Error(fmt::format("there is no body {:.15g}", number), "0 stands for none");
  }
  return Region{static_cast<std::uint32_t>(number)};
}

void set_regions(const Source& source, const Element& f, film::RegionPair pair) {
  source.scene.film.set_regions(Triangle(f.row), f.reversed ? pair.flipped() : pair);
}

// The body that lists the facet with a plus sign lies behind it.
double front_body(const Source& source, const Element& f, int) {
  return regions(source, f).behind.index;
}
double back_body(const Source& source, const Element& f, int) {
  return regions(source, f).front.index;
}
void set_front_body(const Source& source, const Element& f, int, double number) {
  set_regions(source, f, {regions(source, f).front, region_numbered(source, number)});
}
void set_back_body(const Source& source, const Element& f, int, double number) {
  set_regions(source, f, {region_numbered(source, number), regions(source, f).behind});
}
void unset_front_body(const Source& source, const Element& f, int) {
  set_front_body(source, f, 0, 0);
}
void unset_back_body(const Source& source, const Element& f, int) {
  set_back_body(source, f, 0, 0);
}

// --- bodies

scene::Body& body(const Source& source, const Element& b) {
  return source.scene.bodies[b.row];
}

double volume(const Source& source, const Element& b, int) {
  return source.measures.of(source.scene).volumes[b.row + 1];
}
double target(const Source& source, const Element& b, int) {
  return body(source, b).target_volume.value_or(0);
}
void set_target(const Source& source, const Element& b, int, double value) {
  if (!(value > 0) || !std::isfinite(value)) {
    throw text::Error(fmt::format("a target volume must be positive, not {:.15g}", value),
                      "unset body[...] target frees a volume");
  }
  body(source, b).target_volume = value;
  body(source, b).ramp.reset();
  body(source, b).fixed_pressure.reset();
}
void unset_target(const Source& source, const Element& b, int) {
  body(source, b).target_volume.reset();
  body(source, b).ramp.reset();
  body(source, b).pressure = 0;
}
double volume_fixed(const Source& source, const Element& b, int) {
  return body(source, b).fixed_volume() ? 1 : 0;
}
double pressure(const Source& source, const Element& b, int) {
  return body(source, b).fixed_pressure.value_or(body(source, b).pressure);
}
void set_pressure(const Source& source, const Element& b, int, double value) {
  if (!std::isfinite(value)) throw text::Error(fmt::format("a pressure cannot be {}", value));
  if (body(source, b).target_volume) {
    throw text::Error(fmt::format("the volume of body {} is fixed, so its pressure follows", b.row + 1),
                      fmt::format("unset body[{}] target first", b.row + 1));
  }
  body(source, b).fixed_pressure = value;
}
void unset_pressure(const Source& source, const Element& b, int) {
  body(source, b).fixed_pressure.reset();
}
double body_density(const Source& source, const Element& b, int) {
  return body(source, b).density;
}
void set_body_density(const Source& source, const Element& b, int, double value) {
  if (!std::isfinite(value)) throw text::Error(fmt::format("a density cannot be {}", value));
  body(source, b).density = value;
}
void unset_body_density(const Source& source, const Element& b, int) {
  body(source, b).density = 0;
}
double body_phase(const Source& source, const Element& b, int) {
  return body(source, b).phase;
}
double volume_constant(const Source& source, const Element& b, int) {
  return body(source, b).volume_offset;
}
void set_volume_constant(const Source& source, const Element& b, int, double value) {
  if (!std::isfinite(value)) throw text::Error(fmt::format("a volume cannot be {}", value));
  body(source, b).volume_offset = value;
}
double body_original(const Source& source, const Element& b, int) {
  return body(source, b).original;
}

// --- all kinds

double id(const Source& source, const Element& element, int) {
  return number_of(source.scene, element.kind, element.row);
}
double oriented_id(const Source& source, const Element& element, int) {
  return sign(element) * id(source, element, 0);
}

double valence(const Source& source, const Element& element, int) {
  switch (element.kind) {
    case ElementKind::vertex:
      return source.scene.film.valence(Vertex(element.row));
    case ElementKind::edge:
      return source.scene.film.valence(Edge(element.row));
    case ElementKind::facet:
      return 3;
    case ElementKind::body: {
      double facets = 0;
      const Region region{element.row + 1};
      for (std::uint32_t row = 0; row < source.scene.film.triangle_rows(); ++row) {
        if (!source.scene.film.alive(Triangle(row))) continue;
        const film::RegionPair pair = source.scene.film.regions(Triangle(row));
        if (pair.front != pair.behind && (pair.front == region || pair.behind == region)) ++facets;
      }
      return facets;
    }
  }
  return 0;
}

// An edge that no film touches.
double is_wire(const Source& source, const Element& e, int) {
  return source.scene.film.first_side(Edge(e.row)).valid() ? 0 : 1;
}

// --- colors of facets: `color` is that of the front, and of the back too unless there is a column for it

double front_color(const Source& source, const Element& f, int) {
  return column_value(source, f, "color", 0);
}

double back_color(const Source& source, const Element& f, int) {
  const bool own = source.scene.film.columns(film::ElementKind::facet).find("backcolor") != nullptr;
  return column_value(source, f, own ? "backcolor" : "color", 0);
}

void set_both_colors(const Source& source, const Element& f, int, double value) {
  made_column(source, ElementKind::facet, "color").set(f.row, 0, checked_color(value));
  if (film::Column* const back = source.scene.film.columns(film::ElementKind::facet).edit("backcolor"))
    back->set(f.row, 0, value);
}

// The backs keep their colors when fronts and backs part.
void separate_colors(const Source& source) {
  film::Columns& columns = source.scene.film.columns(film::ElementKind::facet);
  if (columns.find("backcolor") != nullptr) return;
  film::Column& back = made_column(source, ElementKind::facet, "backcolor");
  const film::Column* const front = columns.find("color");
  for (std::uint32_t row = 0; front != nullptr && row < columns.rows(); ++row)
    back.set(row, 0, front->value(row));
}

void set_front_color(const Source& source, const Element& f, int, double value) {
  separate_colors(source);
  made_column(source, ElementKind::facet, "color").set(f.row, 0, checked_color(value));
}

void set_back_color(const Source& source, const Element& f, int, double value) {
  separate_colors(source);
  made_column(source, ElementKind::facet, "backcolor").set(f.row, 0, checked_color(value));
}

AttributeRow computed(ElementKind kind, std::string name, std::string summary,
                      decltype(AttributeRow::get) get, decltype(AttributeRow::set) set = nullptr,
                      decltype(AttributeRow::unset) unset = nullptr) {
  return {kind, std::move(name), std::move(summary), {}, {}, get, set, unset, false};
}

AttributeRow kept(ElementKind kind, std::string name, std::string column, std::string summary) {
  return {kind, std::move(name), std::move(summary), std::move(column), {}, nullptr, nullptr, nullptr, false};
}

void add_vertex_rows(std::deque<AttributeRow>& rows) {
  const ElementKind kind = ElementKind::vertex;
  rows.push_back(computed(kind, "x", "coordinate", coordinate_on<0>, set_coordinate_on<0>));
  rows.push_back(computed(kind, "y", "coordinate", coordinate_on<1>, set_coordinate_on<1>));
  rows.push_back(computed(kind, "z", "coordinate", coordinate_on<2>, set_coordinate_on<2>));
  rows.push_back(computed(kind, "x1", "coordinate x", coordinate_on<0>, set_coordinate_on<0>));
  rows.push_back(computed(kind, "x2", "coordinate y", coordinate_on<1>, set_coordinate_on<1>));
  rows.push_back(computed(kind, "x3", "coordinate z", coordinate_on<2>, set_coordinate_on<2>));
  AttributeRow vector = computed(kind, "__x", "the three coordinates", coordinate, set_coordinate);
  vector.shape = {3};
  rows.push_back(vector);
  AttributeRow speed = computed(kind, "velocity", "as evolve moves it", velocity, set_velocity);
  speed.shape = {3};
  rows.push_back(speed);
  rows.push_back(
      computed(kind, "mean_curvature", "mean curvature of the film, 1/r on a sphere", mean_curvature));
  rows.push_back(kept(kind, "fixed", "fixed", "whether it stays where it is"));
  rows.push_back(kept(kind, "bare", "bare", "whether it is meant to have no edges"));
}

void add_edge_rows(std::deque<AttributeRow>& rows) {
  const ElementKind kind = ElementKind::edge;
  rows.push_back(computed(kind, "x", "component of the vector from tail to head", edge_component<0>));
  rows.push_back(computed(kind, "y", "component of the vector from tail to head", edge_component<1>));
  rows.push_back(computed(kind, "z", "component of the vector from tail to head", edge_component<2>));
  rows.push_back(computed(kind, "length", "length", edge_length));
  rows.push_back(
      computed(kind, "dihedral", "angle in radians between the normals of its two facets", dihedral));
  rows.push_back(computed(kind, "wire", "1 if no facet touches it", is_wire));
  rows.push_back(kept(kind, "fixed", "fixed", "whether vertices that split it are fixed"));
  rows.push_back(kept(kind, "bare", "bare", "whether it is meant to have no facets"));
  rows.push_back(kept(kind, "tension", "tension", "energy for each unit of length"));
  rows.push_back(kept(kind, "density", "tension", "the same as tension"));
  rows.push_back(kept(kind, "color", "color", "color, -1 to 15"));
  rows.push_back(kept(kind, "no_refine", "no_refine", "whether refine leaves it alone"));
}

void add_facet_rows(std::deque<AttributeRow>& rows) {
  const ElementKind kind = ElementKind::facet;
  rows.push_back(
      computed(kind, "x", "component of the normal, which is as long as the area", facet_component<0>));
  rows.push_back(
      computed(kind, "y", "component of the normal, which is as long as the area", facet_component<1>));
  rows.push_back(
      computed(kind, "z", "component of the normal, which is as long as the area", facet_component<2>));
  rows.push_back(computed(kind, "area", "area", facet_area));
  rows.push_back(computed(kind, "frontbody", "body that lists it with a plus sign, 0 for none", front_body,
                          set_front_body, unset_front_body));
  rows.push_back(computed(kind, "backbody", "body that lists it with a minus sign, 0 for none", back_body,
                          set_back_body, unset_back_body));
  rows.push_back(computed(kind, "color", "color of both sides, -1 to 15", front_color, set_both_colors));
  rows.push_back(computed(kind, "frontcolor", "color of the front", front_color, set_front_color));
  rows.push_back(computed(kind, "backcolor", "color of the back", back_color, set_back_color));
  rows.push_back(kept(kind, "fixed", "fixed", "whether vertices and edges made inside are fixed"));
  rows.push_back(kept(kind, "tension", "tension", "energy for each unit of area"));
  rows.push_back(kept(kind, "density", "tension", "the same as tension"));
  rows.push_back(kept(kind, "no_refine", "no_refine", "whether refine leaves it alone"));
  rows.push_back(kept(kind, "nodisplay", "nodisplay", "whether pictures leave it out"));
  rows.push_back(kept(kind, "opacity", "opacity", "0 to 1"));
}

void add_body_rows(std::deque<AttributeRow>& rows) {
  const ElementKind kind = ElementKind::body;
  rows.push_back(computed(kind, "volume", "present volume; setting it sets the target", volume, set_target,
                          unset_target));
  rows.push_back(computed(kind, "target", "target volume, 0 for none", target, set_target, unset_target));
  rows.push_back(computed(kind, "volfixed", "whether it has a target volume", volume_fixed));
  rows.push_back(computed(kind, "pressure", "pressure", pressure, set_pressure, unset_pressure));
  rows.push_back(computed(kind, "density", "mass for each unit of volume", body_density, set_body_density,
                          unset_body_density));
  rows.push_back(
      computed(kind, "volconst", "constant added to the volume", volume_constant, set_volume_constant));
  rows.push_back(computed(kind, "phase", "of what is in it; decides tensions in a datafile", body_phase));
  rows.push_back(computed(kind, "original", "its number in the datafile", body_original));
}

}  // namespace

std::deque<AttributeRow> built_in_attributes() {
  std::deque<AttributeRow> rows;
  add_vertex_rows(rows);
  add_edge_rows(rows);
  add_facet_rows(rows);
  add_body_rows(rows);
  add_constraint_attributes(rows);
  for (const ElementKind kind : language::element_kinds) {
    rows.push_back(computed(kind, "id", "number", id));
    rows.push_back(computed(kind, "oid", "number, negative where the element is met reversed", oriented_id));
    rows.push_back(computed(kind, "valence", "how many elements meet in it", valence));
    if (kind != ElementKind::body) {
      rows.push_back(kept(kind, "original", "original", "number in the datafile of what it comes from"));
    }
  }
  return rows;
}

}  // namespace lamella::session
