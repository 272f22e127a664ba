#include "picture/unwrap.h"

#include <cmath>
#include <map>
#include <utility>

#include "film/unfolding.h"

namespace lamella::picture {

namespace {

using film::Edge;
using film::Film;
using film::Region;
using film::RegionPair;
using film::SignedEdge;
using film::Triangle;
using film::Vec3;
using film::Vertex;
using film::Wrap;

class Unwrapper {
 public:
  Unwrapper(const scene::Scene& scene, const Content& content)
      : film_(scene.film),
        content_(content),
        bodies_(scene.bodies.size()),
        offsets_(film::Unfolding::face_offsets(scene.film)) {
    result_.scene.bodies = scene.bodies;
  }

  FilmCopy run() {
    find_homes();
    for (std::uint32_t t = 0; t < film_.triangle_rows(); ++t) add_facet(Triangle(t));
    for (std::uint32_t e = 0; e < film_.edge_rows(); ++e) {
      if (!film_.first_side(Edge(e)).valid()) edge(Edge(e), home_of(film_.position(film_.ends(Edge(e))[0])));
    }
    finish_copy(result_, film_, content_, rows_);
    return std::move(result_);
  }

 private:
  // Moves a point into the cell at the origin.
  Wrap home_of(const Vec3& point) const {
    // Points on a side of the cell belong to it, whatever rounding does to them.
    const Vec3 middle = film_.lattice()->shift({{1, 1, 1}}) / 2;
    return -film_.lattice()->nearest((1 - 1e-9) * (point - middle));
  }

  Vec3 middle_of(Triangle t) const {
    const std::array<Vec3, 3> p = film_.points(t);
    return (p[0] + p[1] + p[2]) / 3;
  }

  // By the middles of the bodies' surfaces.
  void find_homes() {
    std::vector<Vec3> sums(bodies_ + 1);
    std::vector<double> areas(bodies_ + 1, 0);
    for (std::uint32_t t = 0; t < film_.triangle_rows(); ++t) {
      const std::array<Vec3, 3> p = film_.points(Triangle(t));
      const double area = length(cross(p[1] - p[0], p[2] - p[0]));
      const RegionPair pair = film_.regions(Triangle(t));
      for (const auto& [region, face] : {std::pair(pair.behind, 2 * t), std::pair(pair.front, 2 * t + 1)}) {
        sums[region.index] += area * (middle_of(Triangle(t)) + film_.lattice()->shift(offsets_[face]));
        areas[region.index] += area;
      }
    }
    homes_.resize(bodies_ + 1);
    for (std::size_t r = 1; r < homes_.size(); ++r) {
      if (areas[r] > 0) homes_[r] = home_of(sums[r] / areas[r]);
    }
  }

  void add_facet(Triangle t) {
    const RegionPair pair = film_.regions(t);
    const Wrap behind = offsets_[2 * t.index] + homes_[pair.behind.index];
    const Wrap front = offsets_[2 * t.index + 1] + homes_[pair.front.index];
    if (pair.front.outside() && pair.behind.outside()) return copy(t, home_of(middle_of(t)), pair);
    if (!pair.front.outside() && !pair.behind.outside() && front == behind) return copy(t, front, pair);
    if (!pair.front.outside()) copy(t, front, {pair.front, {}});
    if (!pair.behind.outside()) copy(t, behind, {{}, pair.behind});
  }

  void copy(Triangle t, const Wrap& place, RegionPair regions) {
    const std::array<Wrap, 3> corner = film_.corner_wraps(t);
    std::array<SignedEdge, 3> edges;
    for (std::size_t k = 0; k < 3; ++k) {
      const SignedEdge e = film_.edges(t)[k];
      const Wrap& tail = corner[e.reversed() ? (k + 1) % 3 : k];
      edges[k] = SignedEdge(edge(e.edge(), place + tail), e.reversed());
    }
    result_.scene.film.add_triangle(edges, regions);
    rows_.triangles.push_back(t.index);
  }

  Vertex vertex(Vertex v, const Wrap& place) {
    const auto [at, added] = vertices_.try_emplace({v.index, place}, Vertex{});
    if (added) {
      at->second = result_.scene.film.add_vertex(film_.position(v) + film_.lattice()->shift(place));
      rows_.vertices.push_back(v.index);
    }
    return at->second;
  }

  // Of which the tail is moved by `place`.
  Edge edge(Edge e, const Wrap& place) {
    const auto [at, added] = edges_.try_emplace({e.index, place}, Edge{});
    if (added) {
      const auto& [tail, head] = film_.ends(e);
      const Vertex from = vertex(tail, place);
      at->second = result_.scene.film.add_edge(from, vertex(head, place + film_.wrap(SignedEdge(e, false))));
      rows_.edges.push_back(e.index);
    }
    return at->second;
  }

  const Film& film_;
  const Content& content_;
  std::size_t bodies_;
  std::vector<Wrap> offsets_;
  std::vector<Wrap> homes_;  // of each region's surface
  FilmCopy result_;
  CopiedRows rows_;
  std::map<std::pair<std::uint32_t, Wrap>, Vertex> vertices_;
  std::map<std::pair<std::uint32_t, Wrap>, Edge> edges_;
};

}  // namespace

FilmCopy unwrap(const scene::Scene& scene, const Content& content) {
  return Unwrapper(scene, content).run();
}

}  // namespace lamella::picture
