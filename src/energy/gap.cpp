#include "energy/gap.h"

#include <cmath>
#include <cstdlib>

#include "scene/constraint_sets.h"

namespace lamella::energy {

std::vector<GapEdge> gap_edges(const scene::Scene& scene) {
  std::vector<GapEdge> edges;
  bool any = false;
  for (const auto& [number, set] : scene.level_sets) any = any || set.convex;
  if (!any) return edges;
  for (std::uint32_t i = 0; i < scene.film.edge_rows(); ++i) {
    if (!scene.film.alive(film::Edge(i))) continue;
    const auto& ends = scene.film.ends(film::Edge(i));
    for (const int number : scene::constraints_of(scene, film::ElementKind::edge, i)) {
      const auto at = scene.level_sets.find(std::abs(number));
      if (at != scene.level_sets.end() && at->second.convex)
        edges.push_back({&at->second.formula, ends[0], ends[1]});
    }
  }
  return edges;
}

// With the unit normal n at the tail and s = S.n: |S x Q| = |s| w, w = sqrt(S.S - s^2). The normal turns with
// the tail by (1 - n n^T) H / |grad f|, H the Hessian of the level.
EdgeGradient gap_energy(const language::Formula& level, const Vec3& tail, const Vec3& head, double time) {
  const std::array<double, 3> at{tail.x, tail.y, tail.z};
  const language::Jet jet = level.hessian({at, time, {}});
  const Vec3 gradient{jet.gradient[0], jet.gradient[1], jet.gradient[2]};
  const double steepness = length(gradient);
  if (!(steepness > 0)) return {};
  const Vec3 n = gradient / steepness;
  const Vec3 edge = head - tail;
  const double s = dot(edge, n);
  const Vec3 q = edge - s * n;
  const double w = length(q);
  EdgeGradient result;
  result.value = std::abs(s) * w / 6;
  if (!(w > 0)) return result;
  const auto& h = jet.hessian;
  const Vec3 turned = Vec3{h[0] * q.x + h[1] * q.y + h[2] * q.z, h[1] * q.x + h[3] * q.y + h[4] * q.z,
                           h[2] * q.x + h[4] * q.y + h[5] * q.z} /
                      steepness;
  const double sign = s < 0 ? -1 : 1;
  const double by_s = (sign * w - std::abs(s) * s / w) / 6;
  const Vec3 by_edge = (std::abs(s) / (6 * w)) * edge;
  result.to = by_edge + by_s * n;
  result.from = by_s * (turned - n) - by_edge;
  return result;
}

EdgeHessian gap_hessian(const language::Formula& level, const Vec3& tail, const Vec3& head, double time) {
  constexpr double part = 1e-5;  // of the edge: rounding and the third derivative then weigh about the same
  const double h = part * length(head - tail);
  EdgeHessian result;
  if (!(h > 0)) return result;
  const std::array<Vec3, 3> axes{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};
  for (const Vec3& axis : axes) {
    const EdgeGradient tail_up = gap_energy(level, tail + h * axis, head, time);
    const EdgeGradient tail_down = gap_energy(level, tail - h * axis, head, time);
    const EdgeGradient head_up = gap_energy(level, tail, head + h * axis, time);
    const EdgeGradient head_down = gap_energy(level, tail, head - h * axis, time);
    result.from_from += film::outer((0.5 / h) * (tail_up.from - tail_down.from), axis);
    result.to_to += film::outer((0.5 / h) * (head_up.to - head_down.to), axis);
    result.from_to += film::outer((0.5 / h) * (head_up.from - head_down.from), axis);
  }
  result.from_from = 0.5 * (result.from_from + transposed(result.from_from));
  result.to_to = 0.5 * (result.to_to + transposed(result.to_to));
  return result;
}

}  // namespace lamella::energy
