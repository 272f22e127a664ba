#include "session/scene_functions.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "session/attribute_table.h"
#include "session/element_access.h"
#include "session/session.h"
#include "text/error.h"
#include "text/suggest.h"

namespace lamella::session {

using film::Edge;
using film::Film;
using film::SignedEdge;
using film::Triangle;
using film::Vertex;
using language::ElementKind;
using language::Value;

namespace {

using Arguments = std::span<const Value>;

double number(const Value& value) {
  const double* const given = std::get_if<double>(&value);
  if (given == nullptr) throw text::Error("a number is needed here, not a string");
  if (!std::isfinite(*given)) throw text::Error(fmt::format("{} is no number to work with", *given));
  return *given;
}

// A number of an element in the film, without its sign.
std::uint32_t element_number(const Value& value) {
  constexpr double most = 4e9;
  const double magnitude = std::abs(std::trunc(number(value)));
  return magnitude < most ? static_cast<std::uint32_t>(magnitude) : 0;
}

Vertex vertex(const Film& film, const Value& value) {
  const Vertex v = film.vertex_numbered(element_number(value));
  if (!v.valid() || number(value) < 0)
    throw text::Error(fmt::format("there is no vertex {:.15g}", number(value)));
  return v;
}

SignedEdge signed_edge(const Film& film, const Value& value) {
  const Edge e = film.edge_numbered(element_number(value));
  if (!e.valid()) throw text::Error(fmt::format("there is no edge {:.15g}", number(value)));
  return {e, number(value) < 0};
}

Value new_vertex(Session& session, Arguments arguments) {
  Film& film = session.scene().film;
  const Vertex v = film.add_vertex({number(arguments[0]), number(arguments[1]), number(arguments[2])});
  return static_cast<double>(film.number(v));
}

Value new_edge(Session& session, Arguments arguments) {
  Film& film = session.scene().film;
  const Vertex tail = vertex(film, arguments[0]);
  const Vertex head = vertex(film, arguments[1]);
  if (tail == head) throw text::Error("an edge joins two vertices, and these are one");
  return static_cast<double>(film.number(film.add_edge(tail, head)));
}

// The edges must run head to tail and close.
void check_loop(const Film& film, const std::vector<SignedEdge>& edges) {
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const SignedEdge next = edges[(i + 1) % edges.size()];
    if (film.head(edges[i]) == film.tail(next)) continue;
    throw text::Error(fmt::format("edge {} does not begin where edge {} ends", film.number(next.edge()),
                                  film.number(edges[i].edge())),
                      "name the edges around the facet in turn, with a minus where one is walked backward");
  }
}

// A facet of many edges is cut at the mean of its corners, as the datafile's faces are.
std::vector<Triangle> add_pieces(Film& film, const std::vector<SignedEdge>& edges) {
  film::Vec3 sum;
  for (const SignedEdge& e : edges) sum += film.position(film.tail(e));
  const Vertex centre = film.add_vertex(sum / static_cast<double>(edges.size()));
  std::vector<Edge> spokes;
  for (const SignedEdge& e : edges) spokes.push_back(film.add_edge(film.tail(e), centre));
  std::vector<Triangle> pieces;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const Edge next = spokes[(i + 1) % edges.size()];
    pieces.push_back(film.add_triangle({edges[i], SignedEdge(next, false), SignedEdge(spokes[i], true)}, {}));
  }
  return pieces;
}

Value new_facet(Session& session, Arguments arguments) {
  Film& film = session.scene().film;
  std::vector<SignedEdge> edges;
  for (const Value& argument : arguments) edges.push_back(signed_edge(film, argument));
  check_loop(film, edges);
  const std::vector<Triangle> pieces =
      edges.size() == 3 ? std::vector{film.add_triangle({edges[0], edges[1], edges[2]}, {})}
                        : add_pieces(film, edges);
  film::Column& original = made_column(session.attribute_source(), ElementKind::facet, "original");
  const double first = film.number(pieces.front());
  for (const Triangle t : pieces) {
    original.set(t.index, 0, first);
    for (const SignedEdge& e : film.edges(t)) film.sort_sides(e.edge());
  }
  return first;
}

Value new_body(Session& session, Arguments) {
  scene::Scene& scene = session.scene();
  scene.bodies.emplace_back();
  scene.body_columns.resize(scene.bodies.size());
  return static_cast<double>(scene.bodies.size());
}

constexpr std::size_t many = 10000;

constexpr SceneFunction function_table[] = {
    {"new_vertex", "new_vertex(x,y,z): a vertex at a place; its number", {3, 3}, new_vertex},
    {"new_edge", "new_edge(tail,head): an edge between vertices; its number", {2, 2}, new_edge},
    {"new_facet", "new_facet(edge,edge,...): a facet between edges; its number", {3, many}, new_facet},
    {"new_body", "new_body: a body without facets; its number", {0, 0}, new_body},
};

}  // namespace

std::span<const SceneFunction> scene_functions() {
  return function_table;
}

const SceneFunction* find_scene_function(std::string_view name) {
  const std::string key = text::lower(name);
  const auto* const at = std::find_if(std::begin(function_table), std::end(function_table),
                                      [&](const SceneFunction& function) { return function.name == key; });
  return at == std::end(function_table) ? nullptr : at;
}

}  // namespace lamella::session
