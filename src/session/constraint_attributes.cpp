#include "session/constraint_attributes.h"

#include <cmath>

#include <fmt/format.h>

#include "scene/constraint_sets.h"
#include "scene/projection.h"
#include "text/error.h"

namespace lamella::session {

using film::Vertex;
using language::Element;
using language::ElementKind;
using Source = AttributeSource;

namespace {

constexpr int largest_number = 1000000;

const scene::LevelSet& level_set(const scene::Scene& scene, int number) {
  const auto at = scene.level_sets.find(number);
  if (at != scene.level_sets.end()) return at->second;
  throw text::Error(fmt::format("there is no constraint {}", number),
                    "constraints are declared at the top of the datafile");
}

const scene::Boundary& boundary_numbered(const scene::Scene& scene, int number) {
  const auto at = scene.boundaries.find(number);
  if (at != scene.boundaries.end()) return at->second;
  throw text::Error(fmt::format("there is no boundary {}", number),
                    "boundaries are declared at the top of the datafile");
}

// --- constraints; the component is the number less one

double on_constraint(const Source& source, const Element& element, int component) {
  return scene::on_constraint(source.scene, film_kind(element.kind), element.row, component + 1) ? 1 : 0;
}

// As formulas read them now.
double level_at_vertex(const Source& source, const Element& v, int component) {
  scene::LevelSet set = level_set(source.scene, component + 1);
  set.formula.bind(source.scene.variables);
  return scene::level(source.scene, set, Vertex(v.row));
}

// One-sided constraints may be on a vertex without holding it.
double hit_constraint(const Source& source, const Element& v, int component) {
  if (on_constraint(source, v, component) == 0) return 0;
  const scene::LevelSet& set = level_set(source.scene, component + 1);
  if (set.sense == scene::Sense::equal) return 1;
  constexpr double touching = 1e-12;
  const double value = level_at_vertex(source, v, component);
  return (set.sense == scene::Sense::nonnegative ? value <= touching : value >= -touching) ? 1 : 0;
}

// New elements inherit from larger ones, so the smaller ones need as much room.
void reserve_below(scene::Scene& scene, ElementKind kind) {
  const int width = scene::constraint_width(scene, film_kind(kind));
  for (const film::ElementKind below : {film::ElementKind::edge, film::ElementKind::vertex}) {
    if (below < film_kind(kind)) scene::reserve_constraints(scene, below, width);
  }
}

void set_constraint(const Source& source, const Element& element, int component, double) {
  scene::Scene& scene = source.scene;
  const int number = component + 1;
  level_set(scene, number);
  scene::add_constraint(scene, film_kind(element.kind), element.row, number);
  reserve_below(scene, element.kind);
  if (element.kind != ElementKind::vertex) return;
  scene::bind_formulas(scene);
  film::Vec3 point = scene.film.position(Vertex(element.row));
  const std::vector<int> numbers = scene::constraints_of(scene, film::ElementKind::vertex, element.row);
  if (scene::project_to_level_sets(scene, numbers, element.row, point)) {
    scene.film.move(Vertex(element.row), point);
  } else {
    throw text::Error(fmt::format("vertex {} cannot be brought onto its constraints",
                                  scene.film.number(Vertex(element.row))));
  }
}

void unset_constraint(const Source& source, const Element& element, int component) {
  level_set(source.scene, component + 1);
  scene::remove_constraint(source.scene, film_kind(element.kind), element.row, component + 1);
}

// --- boundaries

double on_boundary(const Source& source, const Element& element, int component) {
  const int number = scene::boundary_of(source.scene, film_kind(element.kind), element.row);
  return number == component + 1 ? 1 : 0;
}

double boundary_number(const Source& source, const Element& element, int) {
  return scene::boundary_of(source.scene, film_kind(element.kind), element.row);
}

// Whoever puts a vertex on a boundary sets its parameters afterwards; until then it is at the nearest point.
void set_boundary(const Source& source, const Element& element, int component, double) {
  scene::Scene& scene = source.scene;
  const scene::Boundary& boundary = boundary_numbered(scene, component + 1);
  scene::set_boundary(scene, film_kind(element.kind), element.row, component + 1);
  if (element.kind != ElementKind::vertex) return scene::reserve_boundaries(scene, film::ElementKind::vertex);
  scene::bind_formulas(scene);
  std::array<double, 3> parameters = scene::boundary_parameters(scene, Vertex(element.row));
  const film::Vec3 position = scene.film.position(Vertex(element.row));
  if (!scene::nearest_parameters(scene, boundary, position, parameters)) parameters = {};
  scene::set_boundary_parameters(scene, Vertex(element.row), parameters);
  scene.film.move(Vertex(element.row), scene::boundary_position(scene, boundary, parameters));
}

void unset_boundary(const Source& source, const Element& element, int component) {
  if (on_boundary(source, element, component) != 0)
    scene::set_boundary(source.scene, film_kind(element.kind), element.row, 0);
}

template <std::size_t which>
double parameter(const Source& source, const Element& v, int) {
  return scene::boundary_parameters(source.scene, Vertex(v.row))[which];
}

template <std::size_t which>
void set_parameter(const Source& source, const Element& v, int, double value) {
  scene::Scene& scene = source.scene;
  const int number = scene::boundary_of(scene, film::ElementKind::vertex, v.row);
  if (number == 0) {
    throw text::Error(fmt::format("vertex {} is on no boundary, so it has no parameters",
                                  scene.film.number(Vertex(v.row))));
  }
  if (!std::isfinite(value)) throw text::Error(fmt::format("a parameter cannot be {}", value));
  scene::bind_formulas(scene);
  std::array<double, 3> parameters = scene::boundary_parameters(scene, Vertex(v.row));
  parameters[which] = value;
  scene::set_boundary_parameters(scene, Vertex(v.row), parameters);
  scene.film.move(Vertex(v.row),
                  scene::boundary_position(scene, boundary_numbered(scene, number), parameters));
}

AttributeRow numbered(ElementKind kind, std::string name, std::string summary,
                      decltype(AttributeRow::get) get, decltype(AttributeRow::set) set = nullptr,
                      decltype(AttributeRow::unset) unset = nullptr) {
  return {kind, std::move(name), std::move(summary), {}, {largest_number}, get, set, unset, true};
}

AttributeRow plain(ElementKind kind, std::string name, std::string summary, decltype(AttributeRow::get) get,
                   decltype(AttributeRow::set) set = nullptr) {
  return {kind, std::move(name), std::move(summary), {}, {}, get, set, nullptr, false};
}

}  // namespace

void add_constraint_attributes(std::deque<AttributeRow>& rows) {
  for (const ElementKind kind : {ElementKind::vertex, ElementKind::edge, ElementKind::facet}) {
    rows.push_back(
        numbered(kind, "on_constraint", "whether it is on a constraint: on_constraint 1", on_constraint));
    rows.push_back(numbered(kind, "constraint", "the same; to be set and unset", on_constraint,
                            set_constraint, unset_constraint));
    rows.push_back(numbered(kind, "on_boundary", "whether it is on a boundary: on_boundary 1", on_boundary));
    rows.push_back(numbered(kind, "boundary", "the same; to be set and unset", on_boundary, set_boundary,
                            unset_boundary));
    const std::string name = fmt::format("{}_boundary", language::name_of(kind).substr(0, 1));
    rows.push_back(plain(kind, name, "number of its boundary, 0 for none", boundary_number));
  }
  const ElementKind vertex = ElementKind::vertex;
  rows.push_back(
      numbered(vertex, "hit_constraint", "whether a constraint holds it: hit_constraint 1", hit_constraint));
  rows.push_back(
      numbered(vertex, "value_of_constraint", "the value of a constraint's formula there", level_at_vertex));
  rows.push_back(plain(vertex, "p1", "first parameter on its boundary", parameter<0>, set_parameter<0>));
  rows.push_back(plain(vertex, "p2", "second parameter on its boundary", parameter<1>, set_parameter<1>));
}

}  // namespace lamella::session
