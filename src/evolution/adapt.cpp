#include "evolution/adapt.h"

#include <algorithm>
#include <cmath>

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

// A facet is refined if its error is more than this part of the worst (but for a few outliers).
constexpr double worth_it = 0.35;
constexpr double outliers = 0.02;
// Errors cancel where their sum is less than this part of the sum of their sizes.
constexpr double mostly_alike = 0.9;
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

// Whether an edge stands for a part of a given curve.
bool follows_a_curve(const scene::Scene& scene, Edge e) {
  if (scene::boundary_of(scene, ElementKind::edge, e.index) != 0) return true;
  const auto fixed = scene.film.columns(ElementKind::edge).flags("fixed");
  const bool held = !fixed.empty() && fixed[e.index] != 0;
  return scene::constraints_of(scene, ElementKind::edge, e.index).size() >= (held ? 1U : 2U);
}

// How a curve that a rim edge follows turns, per edge: towards the inside of the curve, by the angles to the
// next edges along it in the mean.
Vec3 turn_of_rim(const scene::Scene& scene, Edge e) {
  const Film& film = scene.film;
  Vec3 sum;
  int count = 0;
  for (int end = 0; end < 2; ++end) {
    const film::Vertex v = film.ends(e)[static_cast<std::size_t>(end)];
    const Vec3 way = film.vector(film::EdgeEnd(e, end).outward());
    film.for_each_end(v, [&](film::EdgeEnd other) {
      if (other.edge() == e || film.valence(other.edge()) == 2 || !follows_a_curve(scene, other.edge()))
        return;
      sum += unit(way) + unit(film.vector(other.outward()));
      ++count;
    });
  }
  return count > 0 ? sum / count : Vec3{};
}

// Of a film at a rim edge: what its chord adds, or cuts off, as far as the film lies in the plane of the
// curve.
double error_at_rim(const scene::Scene& scene, Side side) {
  const Film& film = scene.film;
  const Edge e = film.edge_of(side).edge();
  const Vec3 chord = film.vector(e);
  const Vec3 along = unit(chord);
  const Vec3 apex = film::apex_direction(film, side);
  const Vec3 into = unit(apex - dot(apex, along) * along);
  const double turn = dot(turn_of_rim(scene, e), into);
  return -scene::tension(scene, side.triangle()) * squared_length(chord) * turn / 12;
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

std::vector<FacetError> facet_errors(const scene::Scene& scene) {
  const Film& film = scene.film;
  const bool curves = !scene.boundaries.empty() || !scene.level_sets.empty();
  std::vector<FacetError> errors(film.triangle_rows());
  for (std::uint32_t i = 0; i < film.edge_rows(); ++i) {
    const Side first = film.first_side(Edge(i));
    if (!first.valid()) continue;
    const Side second = film.next_around(first);
    if (second != first && film.next_around(second) == first) {
      const double turn = turn_between(film, first, second);
      for (const Side s : {first, second}) {
        errors[s.triangle().index].inside += 0.5 * scene::tension(scene, s.triangle()) *
                                             length(film::double_area_vector(film, s.triangle())) * turn *
                                             turn / 24;
      }
    } else if (curves && follows_a_curve(scene, Edge(i))) {
      film.for_each_side(Edge(i), [&](Side s) { errors[s.triangle().index].rim += error_at_rim(scene, s); });
    }
  }
  return errors;
}

ErrorSums sum_errors(std::span<const FacetError> errors) {
  ErrorSums sums;
  for (const FacetError& error : errors) {
    sums.whole += error.inside + error.rim;
    sums.sizes += error.size();
  }
  return sums;
}

namespace {

// The edges of facets that are worth it, and what keeps the mesh well shaped.
std::vector<std::uint8_t> worst_edges(const Film& film, std::span<const FacetError> errors) {
  std::vector<double> sorted;
  for (const FacetError& error : errors) sorted.push_back(error.size());
  const auto at =
      sorted.begin() + static_cast<std::ptrdiff_t>((1 - outliers) * static_cast<double>(sorted.size()));
  const double worst = sorted.empty() ? 0 : (std::nth_element(sorted.begin(), at, sorted.end()), *at);
  std::vector<std::uint8_t> halve(film.edge_rows());
  for (std::uint32_t i = 0; i < errors.size(); ++i) {
    if (errors[i].size() < worth_it * worst) continue;
    for (const film::SignedEdge& e : film.edges(Triangle(i))) halve[e.edge().index] = 1;
  }
  while (spread(film, halve)) {
  }
  return halve;
}

// Whether errors of opposite signs cancel each other for a good part.
bool make_up(std::span<const FacetError> errors) {
  const ErrorSums sums = sum_errors(errors);
  return std::abs(sums.whole) < mostly_alike * sums.sizes;
}

// The error left after halving times the number of facets then, which is what uniform refinement keeps. Where
// edges are halved all around, four facets with a sixteenth of the error each follow one; a rim's error falls
// to a quarter.
double cost_after(const Film& film, std::span<const FacetError> errors, std::span<const std::uint8_t> halve) {
  double left = 0;
  double facets = 0;
  for (std::uint32_t i = 0; i < errors.size(); ++i) {
    int halved = 0;
    for (const film::SignedEdge& e : film.edges(Triangle(i))) halved += halve[e.edge().index] != 0 ? 1 : 0;
    facets += 1 + halved;
    left += (errors[i].inside + errors[i].rim) * (halved == 3 ? 0.25 : 1);
  }
  return std::abs(left) * facets;
}

}  // namespace

void refine_everywhere(scene::Scene& scene) {
  const std::uint32_t old_vertices = scene.film.vertex_rows();
  surgery::refine(scene.film);
  scene::settle_vertices(scene, old_vertices);
  film::restore_spatial_order_if_large(scene.film);
}

void refine_smoothly(scene::Scene& scene) {
  refine_smoothly(scene, {});
}

std::uint32_t refine_where_needed(scene::Scene& scene) {
  Film& film = scene.film;
  const std::vector<FacetError> errors = facet_errors(scene);
  const std::vector<std::uint8_t> everywhere(film.edge_rows(), 1);
  std::vector<std::uint8_t> halve = worst_edges(film, errors);
  // What a rim cuts off may make up for what curvature adds, and then it may be best left so.
  if (make_up(errors) && cost_after(film, errors, halve) > cost_after(film, errors, everywhere))
    halve = everywhere;
  const std::uint32_t old_facets = film.triangle_rows();
  refine_smoothly(scene, halve);
  return film.triangle_rows() - old_facets;
}

}  // namespace lamella::evolution
