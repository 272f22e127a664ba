#include "surgery/rebody.h"

#include <vector>

#include "film/union_find.h"

namespace lamella::surgery {

using film::Edge;
using film::Film;
using film::Region;
using film::RegionPair;
using film::Side;
using film::Triangle;

namespace {

// Two films that follow one another around an edge face the same space between them.
void join_around(const Film& film, Edge e, film::UnionFind& faces) {
  film.for_each_side(e, [&](Side s) {
    const Side next = film.next_around(s);
    const bool reversed = film.edge_of(s).reversed();
    const bool next_reversed = film.edge_of(next).reversed();
    if (film.region_after(s) != film.region_before(next)) return;
    faces.join(2 * s.triangle().index + (reversed ? 1U : 0U),
               2 * next.triangle().index + (next_reversed ? 0U : 1U));
  });
}

// Sets of faces of facets: 2t is the front of facet t, 2t + 1 its back.
film::UnionFind faces_of_one_space(const Film& film) {
  film::UnionFind faces(2 * std::size_t{film.triangle_rows()});
  for (std::uint32_t i = 0; i < film.edge_rows(); ++i) {
    if (film.alive(Edge(i))) join_around(film, Edge(i), faces);
  }
  return faces;
}

}  // namespace

std::uint32_t divide_bodies(scene::Scene& scene) {
  Film& film = scene.film;
  film::UnionFind sets = faces_of_one_space(film);
  const auto old_count = static_cast<std::uint32_t>(scene.bodies.size());
  std::vector<std::uint32_t> owner(2 * std::size_t{film.triangle_rows()}, 0);  // body of a set, once known
  std::vector<bool> has_piece(old_count + 1, false);
  const auto region_of = [&](Region old, std::uint32_t face) {
    if (old.outside()) return old;
    std::uint32_t& body = owner[sets.find(face)];
    if (body == 0 && !has_piece[old.index]) {
      has_piece[old.index] = true;
      body = old.index;
    } else if (body == 0) {
      scene::Body copy = scene.body(old);
      if (copy.original == 0) copy.original = old.index;
      scene.bodies.push_back(copy);
      body = static_cast<std::uint32_t>(scene.bodies.size());
    }
    return Region{body};
  };
  for (std::uint32_t i = 0; i < film.triangle_rows(); ++i) {
    const Triangle t(i);
    const RegionPair old = film.alive(t) ? film.regions(t) : RegionPair{};
    if (old.front == old.behind) continue;
    const RegionPair made{region_of(old.front, 2 * i), region_of(old.behind, 2 * i + 1)};
    if (!(made == old)) film.set_regions(t, made);
  }
  scene.body_columns.resize(scene.bodies.size());
  return static_cast<std::uint32_t>(scene.bodies.size()) - old_count;
}

}  // namespace lamella::surgery
