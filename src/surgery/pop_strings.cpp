#include "surgery/pop_strings.h"

#include <algorithm>
#include <array>

#include "surgery/contract.h"
#include "surgery/string_cells.h"

namespace lamella::surgery {

using film::Edge;
using film::EdgeEnd;
using film::Film;
using film::Vec3;
using film::Vertex;

namespace {

constexpr double part_of_string = 0.1;  // the length of the new edge
constexpr double tie = 1e-12;
constexpr std::size_t most_strings = 3;  // that meet in equilibrium

struct Pair {
  EdgeEnd first;
  EdgeEnd second;
  Vec3 pull;  // the sum of their unit vectors
};

std::vector<EdgeEnd> ends_at(const Film& film, Vertex v) {
  std::vector<EdgeEnd> ends;
  film.for_each_end(v, [&](EdgeEnd end) { ends.push_back(end); });
  std::sort(ends.begin(), ends.end(), [](EdgeEnd a, EdgeEnd b) { return a.edge().index < b.edge().index; });
  return ends;
}

// The two that pull together hardest, which are those of the smallest angle.
Pair hardest_pull(const Film& film, const std::vector<EdgeEnd>& ends) {
  Pair best;
  double hardest = -1;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    for (std::size_t j = ends.size() - 1; j > i; --j) {
      const Vec3 pull = unit(film.vector(ends[i].outward())) + unit(film.vector(ends[j].outward()));
      if (length(pull) <= hardest + tie) continue;
      hardest = length(pull);
      best = {ends[i], ends[j], pull};
    }
  }
  return best;
}

void draw_off(Film& film, Vertex v, const Pair& pair) {
  const std::map<int, int> arrived = arrivals(film, std::array{pair.first, pair.second});
  const double reach = part_of_string * std::min(length(film.vector(pair.first.edge())),
                                                 length(film.vector(pair.second.edge())));
  const Vec3 step = reach * unit(pair.pull);
  const Vertex made = film.add_vertex(film.position(v) + step);
  film.inherit(made, v, v, pair.first.edge());
  for (const EdgeEnd end : {pair.first, pair.second}) {
    const Vec3 along = film.vector(end.outward()) - step;
    film.reattach(end, made);
    film.aim(end.outward(), along);
  }
  const Edge joint = film.add_edge(v, made);
  film.inherit(joint, pair.first.edge());
  film.aim(film::SignedEdge(joint, false), step);
  pass_on(film, EdgeEnd(joint, 1), arrived);
}

}  // namespace

std::vector<Vertex> crowded_string_vertices(const scene::Scene& scene) {
  std::vector<Vertex> found;
  for (std::uint32_t row = 0; row < scene.film.vertex_rows(); ++row) {
    const Vertex v(row);
    if (scene.film.alive(v) && is_free(scene, v) && ends_at(scene.film, v).size() > most_strings)
      found.push_back(v);
  }
  return found;
}

PopReport pop_string_vertices(scene::Scene& scene, std::span<const Vertex> vertices) {
  PopReport report;
  for (const Vertex v : vertices) {
    std::vector<EdgeEnd> ends = ends_at(scene.film, v);
    if (ends.size() <= most_strings) continue;
    report.events.push_back({EventKind::pop, scene.film.position(v), {}});
    ++report.vertices;
    for (; ends.size() > most_strings; ends = ends_at(scene.film, v))
      draw_off(scene.film, v, hardest_pull(scene.film, ends));
  }
  return report;
}

}  // namespace lamella::surgery
