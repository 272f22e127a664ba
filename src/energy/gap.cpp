#include "energy/gap.h"

#include <cmath>
#include <cstdlib>

#include "scene/constraint_sets.h"
#include "scene/projection.h"

namespace lamella::energy {

namespace {

bool is_fixed(const scene::Scene& scene, std::uint32_t edge) {
  const auto fixed = scene.film.columns(film::ElementKind::edge).flags("fixed");
  return !fixed.empty() && fixed[edge] != 0;
}

std::vector<double> attributes_at(const scene::Scene& scene, const scene::LevelSet& set, film::Vertex v) {
  return scene::attributes_of(scene.film, set.formula, film::ElementKind::vertex, v.index);
}

}  // namespace

std::vector<GapEdge> gap_edges(const scene::Scene& scene) {
  std::vector<GapEdge> edges;
  bool any = false;
  for (const auto& [number, set] : scene.level_sets) any = any || set.convex;
  if (!any) return edges;
  for (std::uint32_t i = 0; i < scene.film.edge_rows(); ++i) {
    if (!scene.film.alive(film::Edge(i)) || is_fixed(scene, i)) continue;
    const auto& ends = scene.film.ends(film::Edge(i));
    for (const int number : scene::constraints_of(scene, film::ElementKind::edge, i)) {
      const auto at = scene.level_sets.find(std::abs(number));
      if (at != scene.level_sets.end() && at->second.convex)
        edges.push_back({&at->second.formula, ends[0], ends[1], attributes_at(scene, at->second, ends[0]),
                         attributes_at(scene, at->second, ends[1])});
    }
  }
  return edges;
}

namespace {

// The height of an edge above the tangent plane at one of its ends, and its derivatives by the edge and by
// the end, with which the normal turns.
struct Height {
  double value = 0;
  Vec3 by_edge;
  Vec3 by_end;
};

// The unit normal n turns with its point by (1 - n n^T) H / |grad f|, H the Hessian of the level.
Height height_at(const GapEdge& gap, std::span<const double> attributes, const Vec3& edge, const Vec3& end,
                 double time) {
  const std::array<double, 3> at{end.x, end.y, end.z};
  const language::Jet jet = gap.level->hessian({at, time, attributes});
  const Vec3 gradient{jet.gradient[0], jet.gradient[1], jet.gradient[2]};
  const double steepness = length(gradient);
  if (!(steepness > 0)) return {};
  const Vec3 n = gradient / steepness;
  const double s = dot(edge, n);
  const double sign = s < 0 ? -1 : 1;
  const Vec3 q = edge - s * n;
  const auto& h = jet.hessian;
  const Vec3 turned{h[0] * q.x + h[1] * q.y + h[2] * q.z, h[1] * q.x + h[3] * q.y + h[4] * q.z,
                    h[2] * q.x + h[4] * q.y + h[5] * q.z};
  return {std::abs(s), sign * n, (sign / steepness) * turned};
}

}  // namespace

EdgeGradient gap_energy(const GapEdge& gap, const Vec3& tail, const Vec3& head, double time) {
  const Vec3 edge = head - tail;
  const double size = length(edge);
  if (!(size > 0)) return {};
  const Height a = height_at(gap, gap.tail_attributes, edge, tail, time);
  const Height b = height_at(gap, gap.head_attributes, edge, head, time);
  const Vec3 by_edge = ((a.value + b.value) / (12 * size)) * edge + (size / 12) * (a.by_edge + b.by_edge);
  EdgeGradient result;
  result.value = size * (a.value + b.value) / 12;
  result.from = (size / 12) * a.by_end - by_edge;
  result.to = (size / 12) * b.by_end + by_edge;
  return result;
}

// --- boundaries

std::vector<BoundaryGapEdge> boundary_gap_edges(const scene::Scene& scene) {
  std::vector<BoundaryGapEdge> edges;
  bool any = false;
  for (const auto& [number, boundary] : scene.boundaries) any = any || boundary.convex;
  if (!any) return edges;
  for (std::uint32_t i = 0; i < scene.film.edge_rows(); ++i) {
    if (!scene.film.alive(film::Edge(i)) || is_fixed(scene, i)) continue;
    const int number = scene::boundary_of(scene, film::ElementKind::edge, i);
    const auto at = scene.boundaries.find(number);
    if (at == scene.boundaries.end() || !at->second.convex) continue;
    const auto& ends = scene.film.ends(film::Edge(i));
    if (scene::boundary_of(scene, film::ElementKind::vertex, ends[0].index) != number ||
        scene::boundary_of(scene, film::ElementKind::vertex, ends[1].index) != number)
      continue;
    edges.push_back({&at->second, ends[0], ends[1], scene::boundary_parameters(scene, ends[0])[0],
                     scene::boundary_parameters(scene, ends[1])[0]});
  }
  return edges;
}

namespace {

// A curve at a point of it: the derivatives of the position by the parameter.
struct CurvePoint {
  Vec3 first;
  Vec3 second;
};

CurvePoint curve_at(const scene::Scene& scene, const scene::Boundary& boundary, double start,
                    const Vec3& position) {
  std::array<double, 3> parameters{start, 0, 0};
  scene::nearest_parameters(scene, boundary, position, parameters);
  CurvePoint point;
  for (int axis = 0; axis < 3; ++axis) {
    const language::Formula& formula = boundary.position[static_cast<std::size_t>(axis)];
    if (!formula) continue;
    const language::Jet jet = formula.hessian({parameters, scene.time, {}});
    point.first[axis] = jet.gradient[0];
    point.second[axis] = jet.hessian[0];
  }
  return point;
}

// The tangent of the angle between an edge and a curve, and its derivatives by the edge and along the curve.
struct Slope {
  double value = 0;
  Vec3 by_edge;
  Vec3 along;
};

Slope slope_of(const Vec3& edge, const CurvePoint& curve) {
  Slope slope;
  const Vec3& t = curve.first;
  const double product = dot(edge, t);
  const double edges = squared_length(edge);
  const double tangents = squared_length(t);
  slope.value = length(cross(edge, t)) / std::abs(product);
  if (!(slope.value > 0) || !std::isfinite(slope.value)) {
    slope.value = 0;
    return slope;
  }
  const double factor = 1 / (slope.value * product * product);
  slope.by_edge = factor * tangents * (edge - (edges / product) * t);
  const Vec3 by_tangent = factor * edges * (t - (tangents / product) * edge);
  slope.along = (dot(by_tangent, curve.second) / tangents) * t;
  return slope;
}

}  // namespace

EdgeGradient boundary_gap_energy(const scene::Scene& scene, const BoundaryGapEdge& edge, const Vec3& tail,
                                 const Vec3& head) {
  const Vec3 s = head - tail;
  const Slope a = slope_of(s, curve_at(scene, *edge.boundary, edge.tail_parameter, tail));
  const Slope b = slope_of(s, curve_at(scene, *edge.boundary, edge.head_parameter, head));
  const double square = squared_length(s) / 12;
  const Vec3 by_edge = ((a.value + b.value) / 6) * s + square * (a.by_edge + b.by_edge);
  EdgeGradient result;
  result.value = square * (a.value + b.value);
  result.from = square * a.along - by_edge;
  result.to = square * b.along + by_edge;
  return result;
}

namespace {

// By central differences of gradient(tail, head).
template <class Gradient>
EdgeHessian difference_hessian(const Vec3& tail, const Vec3& head, Gradient&& gradient) {
  constexpr double part = 1e-5;  // of the edge: rounding and the third derivative then weigh about the same
  const double h = part * length(head - tail);
  EdgeHessian result;
  if (!(h > 0)) return result;
  const std::array<Vec3, 3> axes{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};
  for (const Vec3& axis : axes) {
    const EdgeGradient tail_up = gradient(tail + h * axis, head);
    const EdgeGradient tail_down = gradient(tail - h * axis, head);
    const EdgeGradient head_up = gradient(tail, head + h * axis);
    const EdgeGradient head_down = gradient(tail, head - h * axis);
    result.from_from += film::outer((0.5 / h) * (tail_up.from - tail_down.from), axis);
    result.to_to += film::outer((0.5 / h) * (head_up.to - head_down.to), axis);
    result.from_to += film::outer((0.5 / h) * (head_up.from - head_down.from), axis);
  }
  result.from_from = 0.5 * (result.from_from + transposed(result.from_from));
  result.to_to = 0.5 * (result.to_to + transposed(result.to_to));
  return result;
}

}  // namespace

EdgeHessian gap_hessian(const GapEdge& edge, const Vec3& tail, const Vec3& head, double time) {
  return difference_hessian(
      tail, head, [&](const Vec3& from, const Vec3& to) { return gap_energy(edge, from, to, time); });
}

EdgeHessian boundary_gap_hessian(const scene::Scene& scene, const BoundaryGapEdge& edge, const Vec3& tail,
                                 const Vec3& head) {
  return difference_hessian(tail, head, [&](const Vec3& from, const Vec3& to) {
    return boundary_gap_energy(scene, edge, from, to);
  });
}

}  // namespace lamella::energy
