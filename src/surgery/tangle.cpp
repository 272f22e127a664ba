#include "surgery/tangle.h"

#include <algorithm>
#include <map>

#include "film/crossing_grid.h"
#include "film/union_find.h"
#include "surgery/wedge.h"

namespace lamella::surgery {

using film::Edge;
using film::EdgeEnd;
using film::Film;
using film::Side;
using film::Triangle;
using film::Vec3;
using film::Vertex;

namespace {

constexpr std::size_t most_met = 8;  // that one facet passes through

}  // namespace

bool is_out_of_order(const Film& film, Edge e) {
  if (film.valence(e) < 3) return false;
  std::vector<Vec3> directions;
  film.for_each_side(e, [&](Side s) { directions.push_back(across(film, s)); });
  return !turns_once(unit(film.vector(e)), directions, 0);
}

Tangle corners_of(const Film& film, Triangle a, Triangle b) {
  Tangle corners(film.corners(a).begin(), film.corners(a).end());
  corners.insert(corners.end(), film.corners(b).begin(), film.corners(b).end());
  return corners;
}

std::vector<Tangle> united(const Film& film, const std::vector<Tangle>& parts) {
  if (parts.empty()) return {};
  film::UnionFind sets(film.vertex_rows());
  for (const Tangle& part : parts) {
    for (const Vertex v : part) sets.join(v.index, part[0].index);
  }
  std::map<std::uint32_t, Tangle> whole;
  for (const Tangle& part : parts) {
    Tangle& into = whole[sets.find(part[0].index)];
    into.insert(into.end(), part.begin(), part.end());
  }
  std::vector<Tangle> result;
  for (auto& [root, vertices] : whole) {
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    result.push_back(std::move(vertices));
  }
  return result;
}

std::vector<Tangle> tangles(const Film& film) {
  std::vector<Tangle> parts;
  for (std::uint32_t i = 0; i < film.edge_rows(); ++i) {
    const Edge e(i);
    if (!film.alive(e) || !is_out_of_order(film, e)) continue;
    Tangle part(film.ends(e).begin(), film.ends(e).end());
    film.for_each_side(e, [&](Side s) { part.push_back(film.opposite(s)); });
    parts.push_back(std::move(part));
  }
  const film::CrossingGrid grid(film);
  for (std::uint32_t i = 0; i < film.triangle_rows(); ++i) {
    const Triangle t(i);
    if (!film.alive(t)) continue;
    for (const Triangle other : grid.crossing(t, most_met)) parts.push_back(corners_of(film, t, other));
  }
  return united(film, parts);
}

Tangle grown(const Film& film, const Tangle& tangle, int rings) {
  Tangle all = tangle;
  for (int ring = 0; ring < rings; ++ring) {
    const std::size_t count = all.size();
    for (std::size_t i = 0; i < count; ++i)
      film.for_each_end(all[i], [&](EdgeEnd end) { all.push_back(film.head(end.outward())); });
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
  }
  return all;
}

}  // namespace lamella::surgery
