#include "picture/explode.h"

#include <algorithm>

namespace lamella::picture {

using film::Edge;
using film::ElementKind;
using film::Film;
using film::Region;
using film::Triangle;
using film::Vec3;
using film::Vertex;

namespace {

// Whether a facet belongs to a body's surface; for the exterior, whether it belongs to none.
bool bounds(film::RegionPair regions, Region body) {
  const bool open = regions.front == regions.behind;
  if (body.outside()) return open;
  return !open && (regions.front == body || regions.behind == body);
}

class Exploder {
 public:
  Exploder(const scene::Scene& from, const Content& content)
      : film_(from.film), from_(from), content_(content) {}

  FilmCopy run() {
    const std::vector<Vec3> from = body_centres(from_);
    const std::vector<Vec3> to = exploded_centres(from_, content_.explode);
    for (std::uint32_t b = 0; b < from.size(); ++b) copy_facets(Region{b}, to[b] - from[b]);
    copy_wires();
    finish_copy(result_, film_, content_, rows_);
    result_.content.explode = 0;
    return std::move(result_);
  }

 private:
  void begin_copy() {
    vertex_of_.assign(film_.vertex_rows(), film::no_index);
    edge_of_.assign(film_.edge_rows(), film::no_index);
  }

  void copy_facets(Region body, const Vec3& shift) {
    begin_copy();
    for (std::uint32_t t = 0; t < film_.triangle_rows(); ++t) {
      if (!film_.alive(Triangle(t)) || !bounds(film_.regions(Triangle(t)), body)) continue;
      std::array<film::SignedEdge, 3> edges;
      for (std::size_t k = 0; k < 3; ++k) {
        const film::SignedEdge e = film_.edges(Triangle(t))[k];
        edges[k] = film::SignedEdge(edge(e.edge(), shift), e.reversed());
      }
      result_.scene.film.add_triangle(edges, {body, body});
      rows_.triangles.push_back(t);
    }
  }

  void copy_wires() {
    begin_copy();
    for (std::uint32_t e = 0; e < film_.edge_rows(); ++e) {
      if (film_.alive(Edge(e)) && !film_.first_side(Edge(e)).valid()) edge(Edge(e), {});
    }
  }

  Vertex vertex(Vertex v, const Vec3& shift) {
    std::uint32_t& row = vertex_of_[v.index];
    if (row == film::no_index) {
      row = result_.scene.film.add_vertex(film_.position(v) + shift).index;
      rows_.vertices.push_back(v.index);
    }
    return Vertex(row);
  }

  Edge edge(Edge e, const Vec3& shift) {
    std::uint32_t& row = edge_of_[e.index];
    if (row == film::no_index) {
      const auto& [tail, head] = film_.ends(e);
      const Vertex from = vertex(tail, shift);
      row = result_.scene.film.add_edge(from, vertex(head, shift)).index;
      rows_.edges.push_back(e.index);
    }
    return Edge(row);
  }

  const Film& film_;
  const scene::Scene& from_;
  const Content& content_;
  FilmCopy result_;
  CopiedRows rows_;
  std::vector<std::uint32_t> vertex_of_;  // in the copy being made
  std::vector<std::uint32_t> edge_of_;
};

}  // namespace

FilmCopy explode(const scene::Scene& scene, const Content& content) {
  return Exploder(scene, content).run();
}

std::vector<Vec3> exploded_centres(const scene::Scene& scene, double amount) {
  std::vector<Vec3> centres = body_centres(scene);
  Vec3 middle;
  for (std::size_t b = 1; b < centres.size(); ++b)
    middle += centres[b] / static_cast<double>(centres.size() - 1);
  for (std::size_t b = 1; b < centres.size(); ++b) centres[b] += amount * (centres[b] - middle);
  return centres;
}

std::vector<Vec3> body_centres(const scene::Scene& scene) {
  const Film& film = scene.film;
  std::vector<Vec3> sums(scene.bodies.size() + 1);
  std::vector<double> areas(sums.size(), 0);
  for (std::uint32_t t = 0; t < film.triangle_rows(); ++t) {
    if (!film.alive(Triangle(t))) continue;
    const auto& c = film.corners(Triangle(t));
    const Vec3 a = film.position(c[0]);
    const Vec3 b = film.position(c[1]);
    const Vec3 d = film.position(c[2]);
    const double area = length(cross(b - a, d - a)) / 2;
    const film::RegionPair regions = film.regions(Triangle(t));
    for (const Region region : {regions.front, regions.behind}) {
      if (region.index >= sums.size() || !bounds(regions, region)) continue;
      sums[region.index] += (area / 3) * (a + b + d);
      areas[region.index] += area;
    }
  }
  for (std::size_t b = 0; b < sums.size(); ++b) sums[b] = areas[b] > 0 ? sums[b] / areas[b] : Vec3{};
  return sums;
}

}  // namespace lamella::picture
