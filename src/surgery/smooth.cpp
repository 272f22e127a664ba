#include "surgery/smooth.h"

#include <algorithm>
#include <vector>

#include "energy/triangle.h"
#include "film/normals.h"
#include "scene/constraint.h"

namespace lamella::surgery {

using film::Column;
using film::EdgeEnd;
using film::ElementKind;
using film::Film;
using film::RegionPair;
using film::Side;
using film::Triangle;
using film::Vec3;
using film::Vertex;

namespace {

constexpr double step = 0.25;

bool is_held(const Film& film, Vertex v) {
  for (const char* const name : {scene::constraint_column, scene::boundary_column}) {
    const Column* const column = film.columns(ElementKind::vertex).find(name);
    for (int k = 0; column != nullptr && k < column->width; ++k) {
      if (column->value(v.index, k) != 0) return true;
    }
  }
  return false;
}

// Whether a neighbour is on all that holds a vertex.
bool is_held_alike(const Film& film, Vertex v, Vertex neighbour) {
  for (const char* const name : {scene::constraint_column, scene::boundary_column}) {
    const Column* const column = film.columns(ElementKind::vertex).find(name);
    for (int k = 0; column != nullptr && k < column->width; ++k) {
      const double number = column->value(v.index, k);
      bool found = number == 0;
      for (int j = 0; j < column->width; ++j) found = found || column->value(neighbour.index, j) == number;
      if (!found) return false;
    }
  }
  return true;
}

struct Neighbour {
  Vec3 position;
  int facets = 0;   // around the edge to it
  double area = 0;  // of those
};

std::vector<Neighbour> neighbours_of(const Film& film, Vertex v) {
  const bool held = is_held(film, v);
  std::vector<Neighbour> result;
  film.for_each_end(v, [&](EdgeEnd end) {
    const Vertex other = film.head(end.outward());
    if (held && !is_held_alike(film, v, other)) return;
    Neighbour neighbour{film.periodic() ? film.position(v) + film.vector(end.outward())
                                        : film.position(other)};
    film.for_each_side(end.edge(), [&](Side s) {
      ++neighbour.facets;
      neighbour.area += 0.5 * length(film::double_area_vector(film, s.triangle()));
    });
    result.push_back(neighbour);
  });
  return result;
}

// The direction in which volumes change: the sum of the vector areas around, where facets of one film count
// alike whichever way they turn.
Vec3 normal_at(const Film& film, Vertex v) {
  Vec3 sum;
  RegionPair first;
  bool any = false;
  film.for_each_end(v, [&](EdgeEnd end) {
    film.for_each_side(end.edge(), [&](Side s) {
      if (film.tail(film.edge_of(s)) != v) return;
      const Vec3 area = film::double_area_vector(film, s.triangle());
      const RegionPair pair = film.regions(s.triangle());
      if (!any) first = pair;
      any = true;
      const bool told = first.front != first.behind && (pair == first || pair == first.flipped());
      const bool turned = told ? !(pair == first) : dot(sum, area) < 0;
      sum += turned ? -area : area;
    });
  });
  return sum;
}

Vec3 mean_of(const std::vector<Neighbour>& neighbours) {
  Vec3 sum;
  for (const Neighbour& neighbour : neighbours) sum += neighbour.position;
  return sum / static_cast<double>(neighbours.size());
}

Vec3 weighted_mean(const std::vector<Neighbour>& neighbours) {
  Vec3 sum;
  double weights = 0;
  for (const Neighbour& neighbour : neighbours) {
    const double weight = neighbour.area * neighbour.area;
    sum += weight * neighbour.position;
    weights += weight;
  }
  return weights > 0 ? sum / weights : mean_of(neighbours);
}

Vec3 without_normal(const Film& film, Vertex v, const Vec3& move) {
  const Vec3 n = unit(normal_at(film, v));
  return move - dot(move, n) * n;
}

}  // namespace

Vec3 averaging_move(const Film& film, Vertex v, Averaging averaging) {
  const auto fixed = film.columns(ElementKind::vertex).flags("fixed");
  if (!film.alive(v) || (!fixed.empty() && fixed[v.index] != 0)) return {};
  const bool keep = averaging == Averaging::keep_volume;
  const Vec3& at = film.position(v);
  std::vector<Neighbour> neighbours = neighbours_of(film, v);
  const auto has = [&](auto&& test) { return std::any_of(neighbours.begin(), neighbours.end(), test); };
  if (neighbours.empty()) return {};
  const auto along_line = [&] {
    const Vec3 move = step * (mean_of(neighbours) - at);
    if (!keep) return move;
    if (neighbours.size() != 2) return Vec3{};
    const Vec3 tangent = unit(neighbours[1].position - neighbours[0].position);
    return dot(move, tangent) * tangent;
  };
  if (has([](const Neighbour& n) { return n.facets == 0; })) {
    // Where there are facets too, a wire leads away from them; without any the film is of one dimension.
    return has([](const Neighbour& n) { return n.facets > 0; }) ? Vec3{} : along_line();
  }
  if (has([](const Neighbour& n) { return n.facets > 2; })) {
    std::erase_if(neighbours, [](const Neighbour& n) { return n.facets <= 2; });
    return neighbours.size() == 2 ? along_line() : Vec3{};
  }
  const bool equal = is_held(film, v) || has([](const Neighbour& n) { return n.facets == 1; });
  const Vec3 move = step * ((equal ? mean_of(neighbours) : weighted_mean(neighbours)) - at);
  return keep ? without_normal(film, v, move) : move;
}

std::uint32_t smooth_vertices(Film& film, Averaging averaging) {
  std::vector<Vec3> moves(film.vertex_rows());
  for (std::uint32_t i = 0; i < film.vertex_rows(); ++i)
    moves[i] = averaging_move(film, Vertex(i), averaging);
  const std::span<Vec3> positions = film.edit_positions();
  std::uint32_t count = 0;
  for (std::size_t v = 0; v < moves.size(); ++v) {
    positions[v] += moves[v];
    count += moves[v] == Vec3{} ? 0 : 1;
  }
  return count;
}

}  // namespace lamella::surgery
