#include "evolution/adapt.h"

#include <algorithm>
#include <cmath>

#include "energy/triangle.h"
#include "evolution/bulge.h"
#include "film/normals.h"
#include "film/order.h"
#include "scene/constraint_sets.h"
#include "surgery/refine.h"

namespace lamella::evolution {

namespace {

using film::Edge;
using film::ElementKind;
using film::Film;
using film::Side;
using film::Triangle;
using film::Vec3;

// A facet is refined if its error is more than this part of the worst (but for a few outliers): halving
// brings the worst down to a sixteenth.
constexpr double worth_it = 1.0 / 10;
constexpr double outliers = 0.02;
// A facet that only one halved edge touches is cut in two if that edge is about its longest.
constexpr double nearly = 0.9;

double edge_length(const Film& film, Edge e) {
  return length(film.vector(e));
}

// The angle by which a film turns at an edge.
double turn_between(const Film& film, Side a, Side b) {
  const Vec3 u = film::double_area_vector(film, a.triangle());
  Vec3 v = film::double_area_vector(film, b.triangle());
  if (film.edge_of(a).reversed() == film.edge_of(b).reversed()) v = -v;
  return std::atan2(length(cross(u, v)), dot(u, v));
}

bool follows_a_curve(const scene::Scene& scene, Edge e) {
  return scene::boundary_of(scene, ElementKind::edge, e.index) != 0 ||
         !scene::constraints_of(scene, ElementKind::edge, e.index).empty();
}

// The angle between a rim edge and the next ones along the same curve, in the mean.
double turn_of_rim(const scene::Scene& scene, Edge e) {
  const Film& film = scene.film;
  double sum = 0;
  int count = 0;
  for (int end = 0; end < 2; ++end) {
    const film::Vertex v = film.ends(e)[static_cast<std::size_t>(end)];
    const Vec3 way = film.vector(film::EdgeEnd(e, end).outward());
    film.for_each_end(v, [&](film::EdgeEnd other) {
      if (other.edge() == e || film.valence(other.edge()) == 2 || !follows_a_curve(scene, other.edge()))
        return;
      const Vec3 next = -film.vector(other.outward());
      sum += std::atan2(length(cross(way, next)), dot(way, next));
      ++count;
    });
  }
  return count > 0 ? sum / count : 0;
}

// What halving may not leave: a facet with two halved edges, or with one that is not its longest.
bool spread(const Film& film, std::vector<std::uint8_t>& halve) {
  bool changed = false;
  for (std::uint32_t i = 0; i < film.triangle_rows(); ++i) {
    const auto& edges = film.edges(Triangle(i));
    int marked = 0;
    double longest = 0;
    double halved = 0;
    for (const film::SignedEdge& e : edges) {
      const double size = edge_length(film, e.edge());
      longest = std::max(longest, size);
      if (halve[e.edge().index] == 0) continue;
      ++marked;
      halved = size;
    }
    if (marked == 0 || marked == 3 || (marked == 1 && halved >= nearly * longest)) continue;
    for (const film::SignedEdge& e : edges) halve[e.edge().index] = 1;
    changed = true;
  }
  return changed;
}

// Halves the chosen edges (all, without flags), their middles where the smooth film is.
void refine_smoothly(scene::Scene& scene, std::span<const std::uint8_t> halve) {
  Film& film = scene.film;
  const auto whole = film.columns(ElementKind::edge).flags("no_refine");
  const std::uint32_t old_vertices = film.vertex_rows();
  const std::vector<Vec3> bulge = bulges(film);
  std::vector<Vec3> moves;
  for (std::uint32_t e = 0; e < film.edge_rows(); ++e) {
    if ((halve.empty() || halve[e] != 0) && (whole.empty() || whole[e] == 0)) moves.push_back(bulge[e]);
  }
  surgery::refine(film, halve);
  const std::span<Vec3> positions = film.edit_positions();
  for (std::size_t i = 0; i < moves.size(); ++i) positions[old_vertices + i] += moves[i];
  scene::settle_vertices(scene, old_vertices);
  film::restore_spatial_order_if_large(film);
}

}  // namespace

std::vector<double> facet_errors(const scene::Scene& scene) {
  const Film& film = scene.film;
  const bool curves = !scene.boundaries.empty() || !scene.level_sets.empty();
  std::vector<double> errors(film.triangle_rows());
  for (std::uint32_t i = 0; i < film.edge_rows(); ++i) {
    const Side first = film.first_side(Edge(i));
    if (!first.valid()) continue;
    const Side second = film.next_around(first);
    if (second == first) {
      if (!curves || !follows_a_curve(scene, Edge(i))) continue;
      const double size = edge_length(film, Edge(i));
      errors[first.triangle().index] += size * size * turn_of_rim(scene, Edge(i)) / 12;
    } else if (film.next_around(second) == first) {
      const double turn = turn_between(film, first, second);
      for (const Side s : {first, second}) {
        errors[s.triangle().index] += 0.5 * scene::tension(scene, s.triangle()) *
                                      length(film::double_area_vector(film, s.triangle())) * turn * turn / 24;
      }
    }
  }
  return errors;
}

void refine_everywhere(scene::Scene& scene) {
  refine_smoothly(scene, {});
}

std::uint32_t refine_where_needed(scene::Scene& scene) {
  Film& film = scene.film;
  const std::vector<double> errors = facet_errors(scene);
  std::vector<double> sorted = errors;
  const auto at =
      sorted.begin() + static_cast<std::ptrdiff_t>((1 - outliers) * static_cast<double>(sorted.size()));
  const double worst = sorted.empty() ? 0 : (std::nth_element(sorted.begin(), at, sorted.end()), *at);
  std::vector<std::uint8_t> halve(film.edge_rows());
  for (std::uint32_t i = 0; i < errors.size(); ++i) {
    if (errors[i] < worth_it * worst) continue;
    for (const film::SignedEdge& e : film.edges(Triangle(i))) halve[e.edge().index] = 1;
  }
  while (spread(film, halve)) {
  }
  const std::uint32_t old_facets = film.triangle_rows();
  refine_smoothly(scene, halve);
  return film.triangle_rows() - old_facets;
}

}  // namespace lamella::evolution
