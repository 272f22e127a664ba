#include "solve/reactions.h"

#include <algorithm>
#include <map>
#include <tuple>

#include "film/union_find.h"
#include "scene/constraint_sets.h"
#include "solve/problem.h"

namespace lamella::solve {

namespace {

using film::ElementKind;
using film::Vertex;

// Rows are told apart, and put in order, by these: the numbers, or the lowest vertex of a wire.
using Key = std::tuple<Holder, std::vector<int>, std::uint32_t>;

film::UnionFind wires(const film::Film& film, const Problem& problem) {
  film::UnionFind sets(film.vertex_rows());
  for (std::uint32_t e = 0; e < film.edge_rows(); ++e) {
    const auto& [tail, head] = film.ends(film::Edge(e));
    if (!problem.movable(tail.index) && !problem.movable(head.index)) sets.join(tail.index, head.index);
  }
  return sets;
}

}  // namespace

std::optional<std::vector<Reaction>> reactions(const scene::Scene& scene) {
  const film::Film& film = scene.film;
  Problem problem(scene);
  bool ok = false;
  problem.linearise(film.positions(), ok);
  std::vector<film::Vec3> free(film.vertex_rows());
  if (!ok) return std::nullopt;
  problem.descent_direction(free);
  film::UnionFind wire = wires(film, problem);
  std::map<Key, Reaction> found;
  for (std::uint32_t v = 0; v < film.vertex_rows(); ++v) {
    const bool fixed = !problem.movable(v);
    if (!fixed && !problem.energy().constraints().holds(v)) continue;
    const int boundary = scene::boundary_of(scene, ElementKind::vertex, v);
    Key key{Holder::wire, {}, wire.find(v)};
    if (boundary != 0)
      key = {Holder::boundary, {boundary}, 0};
    else if (!fixed)
      key = {Holder::constraints, scene::constraints_of(scene, ElementKind::vertex, v), 0};
    Reaction& reaction = found[key];
    if (reaction.vertices++ == 0) reaction = {std::get<0>(key), std::get<1>(key), Vertex(v), 1, {}};
    reaction.pull += problem.force(v) - free[v];
  }
  std::vector<Reaction> result;
  for (const auto& [key, reaction] : found) result.push_back(reaction);
  return result;
}

}  // namespace lamella::solve
