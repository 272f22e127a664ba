#include "surgery/vanish.h"

#include <algorithm>
#include <cmath>

#include "film/normals.h"
#include "film/union_find.h"
#include "surgery/contract.h"
#include "surgery/patch.h"
#include "surgery/sizing.h"

namespace lamella::surgery {

using film::EdgeEnd;
using film::Film;
using film::Region;
using film::RegionPair;
using film::Triangle;
using film::Vec3;
using film::Vertex;
using scene::Scene;

namespace {

// Of the cube and the square of the mesh's size. A tetrahedron whose edges are about to collapse has a volume
// of 0.015.
constexpr double least_volume = 0.02;
constexpr double least_area = 0.2;
constexpr double reach = 1.0;  // of a small part, from its middle, in sizes
constexpr std::size_t most_facets = 60;
constexpr double any_gain = -1e30;  // a contraction is made even if it costs energy

// Facets that may be small together.
struct Part {
  Region region;  // or outside: a piece of film
  std::vector<Triangle> facets;
  double volume = 0;
};

std::vector<Vertex> vertices_of(const Film& film, const std::vector<Triangle>& facets) {
  std::vector<Vertex> vertices;
  for (const Triangle t : facets)
    vertices.insert(vertices.end(), film.corners(t).begin(), film.corners(t).end());
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

Vec3 middle_of(const Film& film, const std::vector<Vertex>& vertices) {
  Vec3 sum;
  for (const Vertex v : vertices) sum += film.position(v) / static_cast<double>(vertices.size());
  return sum;
}

double mean_size(const Film& film, const std::vector<Vertex>& vertices) {
  double sum = 0;
  for (const Vertex v : vertices) sum += size_of(film, v);
  return sum / static_cast<double>(vertices.size());
}

bool is_within_reach(const Film& film, const std::vector<Vertex>& vertices, double size) {
  const Vec3 middle = middle_of(film, vertices);
  return std::all_of(vertices.begin(), vertices.end(),
                     [&](Vertex v) { return length(film.position(v) - middle) < reach * size; });
}

// Facets by region; only those of few facets.
std::vector<Part> parts_by_region(const Film& film, std::size_t bodies) {
  std::vector<Part> parts(bodies + 1);
  std::vector<Vec3> origin(bodies + 1);
  for (std::uint32_t i = 0; i < film.triangle_rows(); ++i) {
    const Triangle t(i);
    if (!film.alive(t)) continue;
    const RegionPair pair = film.regions(t);
    const auto p = film.points(t);
    for (const auto& [region, sign] : {std::pair(pair.behind, 1.0), std::pair(pair.front, -1.0)}) {
      if (region.outside() || region.index > bodies || pair.front == pair.behind) continue;
      Part& part = parts[region.index];
      Vec3& o = origin[region.index];
      if (part.facets.empty()) o = p[0];
      part.volume += sign * dot(p[0] - o, cross(p[1] - o, p[2] - o)) / 6;
      if (part.facets.size() <= most_facets) part.facets.push_back(t);
    }
  }
  for (std::uint32_t r = 1; r <= bodies; ++r) parts[r].region = Region{r};
  std::erase_if(parts, [](const Part& p) { return p.facets.empty() || p.facets.size() > most_facets; });
  return parts;
}

// Facets by pieces that hang together; only those of few facets.
std::vector<Part> pieces(const Film& film) {
  film::UnionFind sets(film.vertex_rows());
  for (std::uint32_t i = 0; i < film.edge_rows(); ++i) {
    const film::Edge e(i);
    if (film.alive(e)) sets.join(film.ends(e)[0].index, film.ends(e)[1].index);
  }
  std::vector<std::uint32_t> row(sets.size(), film::no_index);
  std::vector<Part> parts;
  for (std::uint32_t i = 0; i < film.triangle_rows(); ++i) {
    const Triangle t(i);
    if (!film.alive(t)) continue;
    std::uint32_t& at = row[sets.find(film.corners(t)[0].index)];
    if (at == film::no_index) {
      at = static_cast<std::uint32_t>(parts.size());
      parts.emplace_back();
    }
    if (parts[at].facets.size() <= most_facets) parts[at].facets.push_back(t);
  }
  std::erase_if(parts, [](const Part& p) { return p.facets.size() > most_facets; });
  return parts;
}

// A piece that encloses nothing; those that do are judged by their regions.
bool is_small_piece(const Film& film, const Part& part) {
  double area = 0;
  for (const Triangle t : part.facets) {
    const RegionPair pair = film.regions(t);
    if (pair.front != pair.behind) return false;
    area += 0.5 * length(film::double_area_vector(film, t));
  }
  const std::vector<Vertex> vertices = vertices_of(film, part.facets);
  const double size = mean_size(film, vertices);
  return area < least_area * size * size && is_within_reach(film, vertices, size);
}

bool is_small_region(const Film& film, const Part& part) {
  const std::vector<Vertex> vertices = vertices_of(film, part.facets);
  const double size = mean_size(film, vertices);
  return part.volume < least_volume * size * size * size && is_within_reach(film, vertices, size);
}

bool is_held(const Scene& scene, const std::vector<Vertex>& vertices) {
  return std::any_of(vertices.begin(), vertices.end(), [&](Vertex v) { return !is_free(scene, v); });
}

std::vector<Part> small_parts(const Scene& scene) {
  std::vector<Part> found = parts_by_region(scene.film, scene.bodies.size());
  std::erase_if(found, [&](const Part& p) {
    return !is_small_region(scene.film, p) || is_held(scene, vertices_of(scene.film, p.facets));
  });
  std::sort(found.begin(), found.end(), [](const Part& a, const Part& b) { return a.volume < b.volume; });
  for (Part& piece : pieces(scene.film)) {
    if (is_small_piece(scene.film, piece) && !is_held(scene, vertices_of(scene.film, piece.facets)))
      found.push_back(std::move(piece));
  }
  return found;
}

void take_out(Scene& scene, const Part& part, Vanished& done) {
  const std::vector<Vertex> vertices = vertices_of(scene.film, part.facets);
  done.events.push_back(
      {EventKind::vanish, middle_of(scene.film, vertices), regions_at(scene.film, part.facets)});
  replace(scene.film, {part.facets, {}});
}

void shrink_to_point(Scene& scene, const Part& part, Vanished& done) {
  const std::vector<Vertex> vertices = vertices_of(scene.film, part.facets);
  const Link link = link_of(scene.film, vertices);
  if (link.nodes.empty()) {
    take_out(scene, part, done);
    return;
  }
  const ContractOptions options{
      .size = mean_size(scene.film, vertices), .gain = any_gain, .only = {}, .vanishes = part.region};
  const auto contraction = contract(scene, vertices, options);
  if (!contraction) return;
  Event event = contraction->event;
  event.kind = EventKind::vanish;
  event.regions.push_back(part.region);
  std::sort(event.regions.begin(), event.regions.end());
  done.events.push_back(std::move(event));
  for (const Vertex v : contraction->made) {
    done.touched.push_back(v);
    scene.film.for_each_end(v, [&](EdgeEnd end) { done.touched.push_back(scene.film.head(end.outward())); });
  }
}

}  // namespace

bool has_small_parts(const Scene& scene) {
  return !small_parts(scene).empty();
}

Vanished vanish_small_parts(Scene& scene) {
  Vanished done;
  for (const Part& part : small_parts(scene)) {
    // An earlier one may have taken its neighbours' facets with it.
    const bool whole =
        std::all_of(part.facets.begin(), part.facets.end(), [&](Triangle t) { return scene.film.alive(t); });
    if (!whole) continue;
    if (part.region.outside())
      take_out(scene, part, done);
    else
      shrink_to_point(scene, part, done);
  }
  return done;
}

}  // namespace lamella::surgery
