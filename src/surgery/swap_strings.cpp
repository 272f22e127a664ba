#include "surgery/swap_strings.h"

#include <array>
#include <cstdlib>
#include <utility>
#include <vector>

#include "surgery/contract.h"
#include "surgery/string_cells.h"

namespace lamella::surgery {

using film::Edge;
using film::EdgeEnd;
using film::Film;
using film::Vec3;
using film::Vertex;

namespace {

// The other two ends at an end of a string, if they are two.
std::optional<std::array<EdgeEnd, 2>> others_at(const Film& film, EdgeEnd end) {
  std::vector<EdgeEnd> others;
  film.for_each_end(film.at(end), [&](EdgeEnd other) {
    if (other.edge() != end.edge()) others.push_back(other);
  });
  if (others.size() != 2 || film.valence(film.at(end)) != 3) return std::nullopt;
  return std::array{others[0], others[1]};
}

bool is_in_cell(const Film& film, Edge edge, int cell) {
  const film::Column* const cells = film.columns(film::ElementKind::edge).find(scene::cells_column);
  for (int k = 0; cells != nullptr && k < cells->width; ++k) {
    if (std::abs(static_cast<int>(cells->value(edge.index, k))) == cell) return true;
  }
  return false;
}

// The cell that walks a string from its head to its tail; 0 where there is none.
int cell_against(const Film& film, Edge edge) {
  const film::Column* const cells = film.columns(film::ElementKind::edge).find(scene::cells_column);
  for (int k = 0; cells != nullptr && k < cells->width; ++k) {
    if (cells->value(edge.index, k) < 0) return -static_cast<int>(cells->value(edge.index, k));
  }
  return 0;
}

bool share_a_string(const std::array<EdgeEnd, 2>& a, const std::array<EdgeEnd, 2>& b) {
  for (const EdgeEnd from : a) {
    for (const EdgeEnd to : b) {
      if (from.edge() == to.edge()) return true;
    }
  }
  return a[0].edge() == a[1].edge() || b[0].edge() == b[1].edge();
}

}  // namespace

std::optional<Event> swap_at_string(scene::Scene& scene, Edge edge) {
  Film& film = scene.film;
  const std::array<EdgeEnd, 2> ends{EdgeEnd(edge, 0), EdgeEnd(edge, 1)};
  const std::array<Vertex, 2> at = film.ends(edge);
  auto tail = others_at(film, ends[0]);
  auto head = others_at(film, ends[1]);
  if (!tail || !head || share_a_string(*tail, *head) || !is_free(scene, at[0]) || !is_free(scene, at[1]))
    return std::nullopt;
  // Beside the cell that walks it backward the strings go on to its tail, as in Surface Evolver.
  if (const int cell = cell_against(film, edge); cell != 0 && !is_in_cell(film, (*tail)[0].edge(), cell))
    std::swap((*tail)[0], (*tail)[1]);
  const auto pull = [&](EdgeEnd end) { return unit(film.vector(end.outward())); };
  const Vec3 along = film.vector(edge);
  const Vec3 across = pull((*tail)[0]) - pull((*tail)[1]);
  const Vec3 side = unit(across - dot(across, along) / squared_length(along) * along);
  if (!(squared_length(side) > 0)) return std::nullopt;
  if (dot(pull((*head)[0]) - pull((*head)[1]), side) < 0) std::swap((*head)[0], (*head)[1]);

  // Places as seen from the tail.
  const Vec3 middle = along / 2;
  const std::array<Vec3, 2> from{Vec3{}, along};
  const std::array<Vec3, 2> to{middle + length(along) / 2 * side, middle - length(along) / 2 * side};
  struct Hanging {
    EdgeEnd end;
    std::size_t of;  // the end of the string at which it is afterwards
    Vec3 far;
  };
  std::vector<Hanging> hanging;
  for (std::size_t k = 0; k < 2; ++k) {
    hanging.push_back({(*tail)[k], k, from[0] + film.vector((*tail)[k].outward())});
    hanging.push_back({(*head)[k], k, from[1] + film.vector((*head)[k].outward())});
  }
  const Event event{EventKind::t1, film.position(at[0]) + middle, {}};
  for (std::size_t k = 0; k < 2; ++k) film.move(at[k], film.position(at[k]) + to[k] - from[k]);
  film.aim(film::SignedEdge(edge, false), to[1] - to[0]);
  for (const Hanging& string : hanging) {
    if (film.at(string.end) != at[string.of]) film.reattach(string.end, at[string.of]);
    film.aim(string.end.outward(), string.far - to[string.of]);
  }
  pass_on(film, ends[0], arrivals(film, std::array{(*tail)[0], (*head)[0]}));
  return event;
}

}  // namespace lamella::surgery
