#include "scene/append.h"

#include <algorithm>
#include <cstdlib>

#include <fmt/format.h>

#include "scene/constraint_sets.h"
#include "text/error.h"

namespace lamella::scene {

using film::Column;
using film::Columns;
using film::Edge;
using film::ElementKind;
using film::Film;
using film::Side;
using film::SignedEdge;
using film::Triangle;
using film::Vertex;

namespace {

// How many rows of each kind were there before.
struct Offsets {
  std::uint32_t vertices = 0;
  std::uint32_t edges = 0;
  std::uint32_t triangles = 0;
  std::uint32_t bodies = 0;

  std::uint32_t of(ElementKind kind) const {
    switch (kind) {
      case ElementKind::vertex:
        return vertices;
      case ElementKind::edge:
        return edges;
      case ElementKind::facet:
        return triangles;
      default:
        return bodies;
    }
  }
};

using NewNumbers = std::map<int, int>;

void append_complex(Film& film, const Film& other, const Offsets& offset) {
  const auto moved = [&](SignedEdge e) {
    return SignedEdge(Edge(e.edge().index + offset.edges), e.reversed());
  };
  const auto region = [&](film::Region r) {
    return film::Region{r.index == 0 ? 0 : r.index + offset.bodies};
  };
  for (std::uint32_t v = 0; v < other.vertex_rows(); ++v) film.add_vertex(other.position(Vertex(v)));
  for (std::uint32_t e = 0; e < other.edge_rows(); ++e) {
    const auto [tail, head] = other.ends(Edge(e));
    film.add_edge(Vertex(tail.index + offset.vertices), Vertex(head.index + offset.vertices));
  }
  for (std::uint32_t t = 0; t < other.triangle_rows(); ++t) {
    const auto& edges = other.edges(Triangle(t));
    const film::RegionPair pair = other.regions(Triangle(t));
    film.add_unlinked_triangle({moved(edges[0]), moved(edges[1]), moved(edges[2])},
                               {region(pair.front), region(pair.behind)});
  }
  for (std::uint32_t e = 0; e < other.edge_rows(); ++e) {
    std::vector<Side> ring;
    other.for_each_side(Edge(e), [&](Side s) {
      ring.emplace_back(Triangle(s.triangle().index + offset.triangles), s.corner());
    });
    if (!ring.empty()) film.set_ring(Edge(e + offset.edges), ring);
  }
}

// Declarations by number, with those of a name under their own or a free one.
template <class Set>
NewNumbers append_sets(std::map<int, Set>& sets, const std::map<int, Set>& others) {
  NewNumbers numbers;
  for (const auto& other : others) {
    const int number = other.first;
    const Set& set = other.second;
    const auto same = std::find_if(sets.begin(), sets.end(), [&](const auto& known) {
      return !set.name.empty() && known.second.name == set.name;
    });
    int into = number;
    if (same != sets.end()) {
      into = same->first;
    } else if (const auto taken = sets.find(number);
               taken != sets.end() && (!set.name.empty() || !taken->second.name.empty())) {
      into = sets.rbegin()->first + 1;
    }
    numbers[number] = into;
    sets.insert_or_assign(into, set);
  }
  return numbers;
}

// The column of this name, added if the scene has none like it.
Column& column_like(Columns& columns, const Column& other) {
  if (columns.find(other.name) == nullptr) {
    Column made = other;
    made.resize(0);
    columns.add(std::move(made));
  }
  Column& column = *columns.edit(other.name);
  if (column.shape != other.shape)
    throw text::Error(fmt::format("the attribute \"{}\" has another shape in the file", other.name),
                      "attributes of the same name must have the same size");
  return column;
}

void append_constraints(Scene& scene, ElementKind kind, const Column& column, std::uint32_t offset,
                        const NewNumbers& numbers) {
  const auto rows = static_cast<std::uint32_t>(scene.film.columns(kind).rows()) - offset;
  for (std::uint32_t row = 0; row < rows; ++row) {
    for (int k = 0; k < column.width; ++k) {
      const int number = static_cast<int>(column.value(row, k));
      if (number == 0) continue;
      const int now = numbers.at(std::abs(number));
      add_constraint(scene, kind, offset + row, number < 0 ? -now : now);
    }
  }
}

void append_columns(Columns& columns, const Columns& others, std::uint32_t offset,
                    const NewNumbers& boundaries) {
  others.for_each([&](const Column& other) {
    if (other.name == constraint_column) return;
    Column& column = column_like(columns, other);
    for (std::uint32_t row = 0; row < others.rows(); ++row) column.copy_row_of(other, row, offset + row);
    if (other.name != boundary_column) return;
    for (std::uint32_t row = 0; row < others.rows(); ++row) {
      const int number = static_cast<int>(other.value(row));
      if (number != 0) column.set(offset + row, 0, boundaries.at(number));
    }
  });
}

void refuse_what_does_not_append(const Scene& scene) {
  if (scene.strings.on || scene.film.periodic())
    throw text::Error("only films of facets in space that does not repeat itself can be put together");
}

}  // namespace

void append(Scene& scene, const Scene& other) {
  refuse_what_does_not_append(scene);
  refuse_what_does_not_append(other);
  const Offsets offset{scene.film.vertex_rows(), scene.film.edge_rows(), scene.film.triangle_rows(),
                       static_cast<std::uint32_t>(scene.bodies.size())};
  append_complex(scene.film, other.film, offset);
  const NewNumbers level_sets = append_sets(scene.level_sets, other.level_sets);
  const NewNumbers boundaries = append_sets(scene.boundaries, other.boundaries);
  for (const ElementKind kind : {ElementKind::vertex, ElementKind::edge, ElementKind::facet}) {
    append_columns(scene.film.columns(kind), other.film.columns(kind), offset.of(kind), boundaries);
    if (const Column* const constraints = other.film.columns(kind).find(constraint_column))
      append_constraints(scene, kind, *constraints, offset.of(kind), level_sets);
  }
  scene.bodies.insert(scene.bodies.end(), other.bodies.begin(), other.bodies.end());
  scene.body_columns.resize(scene.bodies.size());
  append_columns(scene.body_columns, other.body_columns, offset.bodies, boundaries);
  for (const Quantity& quantity : other.quantities) {
    const auto same = std::find_if(scene.quantities.begin(), scene.quantities.end(),
                                   [&](const Quantity& known) { return known.name == quantity.name; });
    if (same == scene.quantities.end())
      scene.quantities.push_back(quantity);
    else
      *same = quantity;
  }
  other.variables.for_each([&](language::VariableId id, const language::Variable& variable) {
    if (!variable.is_array()) scene.variables.set(id, variable.value);
  });
}

}  // namespace lamella::scene
