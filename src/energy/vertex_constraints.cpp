#include "energy/vertex_constraints.h"

#include <algorithm>
#include <cmath>

#include "scene/projection.h"

namespace lamella::energy {

using film::ElementKind;
using scene::LevelSet;
using scene::Sense;

namespace {

// A vertex this near to a one-sided level, in units of the gradient's length, is on it.
constexpr double touching = 1e-12;

bool beyond_or_on(const LevelSet& set, const scene::Level& level) {
  const double tolerance = touching * (1 + length(level.gradient));
  return set.sense == Sense::nonnegative ? level.value <= tolerance : level.value >= -tolerance;
}

}  // namespace

VertexConstraints::VertexConstraints(const scene::Scene& scene) {
  if (scene.level_sets.empty() && scene.boundaries.empty()) return;
  scene_ = scene;
  scene::bind_formulas(scene_);
  const std::uint32_t vertices = scene.film.vertex_rows();
  index_.assign(vertices, none);
  const auto fixed = scene.film.columns(ElementKind::vertex).flags("fixed");
  for (std::uint32_t v = 0; v < vertices; ++v) {
    Held held;
    held.vertex = v;
    held.fixed = !fixed.empty() && fixed[v] != 0;
    held.boundary = scene::boundary_of(scene, ElementKind::vertex, v);
    if (!scene.boundaries.contains(held.boundary)) held.boundary = 0;
    if (held.boundary != 0) {
      held.parameters = scene::boundary_parameters(scene, film::Vertex(v));
    } else {
      for (const int number : scene::constraints_of(scene, ElementKind::vertex, v)) {
        const auto at = scene.level_sets.find(std::abs(number));
        if (at == scene.level_sets.end()) continue;
        held.level_sets.push_back(at->first);
        one_sided_ = one_sided_ || at->second.sense != Sense::equal;
      }
    }
    if (held.boundary == 0 && held.level_sets.empty()) continue;
    index_[v] = static_cast<std::uint32_t>(held_.size());
    held_.push_back(std::move(held));
  }
  scene_.film.edit_position_rows() = {};
  for (const auto& [number, set] : scene_.level_sets) moves_ = moves_ || set.formula.depends_on_time();
  for (const auto& [number, boundary] : scene_.boundaries) {
    for (const language::Formula& formula : boundary.position) moves_ = moves_ || formula.depends_on_time();
  }
}

void VertexConstraints::renew_levels(Held& held, const Vec3& at, const Vec3* force) {
  held.count = 0;
  for (const int number : held.level_sets) {
    if (held.count == 3) break;
    const LevelSet& set = scene_.level_sets.at(number);
    const scene::Level level = scene::level_at(scene_, set, at, held.vertex);
    if (set.sense != Sense::equal) {
      if (!beyond_or_on(set, level)) continue;
      const double outward = set.sense == Sense::nonnegative ? -1 : 1;
      if (force != nullptr && outward * dot(*force, level.gradient) < 0) continue;
    }
    held.active[static_cast<std::size_t>(held.count)] = number;
    held.directions[static_cast<std::size_t>(held.count++)] = level.gradient;
  }
  held.active_count = held.count;
  held.count = scene::orthonormalise(std::span(held.directions.data(), static_cast<std::size_t>(held.count)));
}

void VertexConstraints::renew_boundary(Held& held, const Vec3& at) {
  const scene::Boundary& boundary = scene_.boundaries.at(held.boundary);
  if (!held.fixed) scene::nearest_parameters(scene_, boundary, at, held.parameters);
  const scene::BoundaryPoint point = scene::boundary_point(scene_, boundary, held.parameters);
  held.directions = point.tangents;
  held.count =
      scene::orthonormalise(std::span(held.directions.data(), static_cast<std::size_t>(boundary.parameters)));
}

void VertexConstraints::renew(std::span<const Vec3> x, std::span<const Vec3> force) {
  for (Held& held : held_) {
    if (held.boundary != 0) {
      renew_boundary(held, x[held.vertex]);
    } else {
      renew_levels(held, x[held.vertex], force.empty() ? nullptr : &force[held.vertex]);
    }
  }
}

Vec3 VertexConstraints::restricted_by(const Held& held, const Vec3& vector) {
  Vec3 along;
  for (int i = 0; i < held.count; ++i) {
    const Vec3& d = held.directions[static_cast<std::size_t>(i)];
    along += dot(vector, d) * d;
  }
  return held.boundary != 0 ? along : vector - along;
}

void VertexConstraints::restrict(std::span<Vec3> field) const {
  for (const Held& held : held_) field[held.vertex] = restricted_by(held, field[held.vertex]);
}

int VertexConstraints::allowed(std::uint32_t vertex, std::array<Vec3, 3>& directions) const {
  const Held& held = held_[index_[vertex]];
  if (held.boundary != 0) {
    directions = held.directions;
    return held.count;
  }
  // What is left of the axes when the forbidden directions are taken out.
  std::array<Vec3, 6> all;
  for (int i = 0; i < held.count; ++i)
    all[static_cast<std::size_t>(i)] = held.directions[static_cast<std::size_t>(i)];
  const std::array<Vec3, 3> axes{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};
  int count = 0;
  for (const Vec3& axis : axes) {
    if (count == 3 - held.count) break;
    Vec3 v = axis;
    for (int i = 0; i < held.count + count; ++i)
      v -= dot(v, all[static_cast<std::size_t>(i)]) * all[static_cast<std::size_t>(i)];
    if (length(v) < 0.5) continue;  // the others are nearer to what is left
    all[static_cast<std::size_t>(held.count + count)] = directions[static_cast<std::size_t>(count)] = unit(v);
    ++count;
  }
  return count;
}

film::Mat3 VertexConstraints::curvature(std::uint32_t vertex, const Vec3& at, const Vec3& force) const {
  const Held& held = held_[index_[vertex]];
  return held.boundary != 0 ? boundary_curvature(held, force) : level_curvature(held, at, force);
}

// The force across is a sum of gradients; each level's share times its Hessian.
film::Mat3 VertexConstraints::level_curvature(const Held& held, const Vec3& at, const Vec3& force) const {
  std::array<Vec3, 3> gradients;
  std::array<film::Mat3, 3> hessians;
  const auto count = static_cast<std::size_t>(held.active_count);
  for (std::size_t i = 0; i < count; ++i) {
    const scene::LevelSet& set = scene_.level_sets.at(held.active[i]);
    std::vector<double> attributes;
    if (!set.formula.attributes().empty())
      attributes = scene::attributes_of(scene_.film, set.formula, film::ElementKind::vertex, held.vertex);
    const language::Jet jet = set.formula.hessian({std::array{at.x, at.y, at.z}, scene_.time, attributes});
    gradients[i] = {jet.gradient[0], jet.gradient[1], jet.gradient[2]};
    hessians[i] = film::symmetric(jet.hessian);
  }
  const std::array<double, 3> share = scene::shares(std::span(gradients.data(), count), force);
  film::Mat3 block;
  for (std::size_t i = 0; i < count; ++i) block += share[i] * hessians[i];
  return block;
}

// u = sum of tangents times changes of parameters; the curve bends away by half its second derivative.
film::Mat3 VertexConstraints::boundary_curvature(const Held& held, const Vec3& force) const {
  const scene::Boundary& boundary = scene_.boundaries.at(held.boundary);
  const scene::BoundaryPoint point = scene::boundary_point(scene_, boundary, held.parameters);
  const auto count = static_cast<std::size_t>(boundary.parameters);
  const std::span tangents(point.tangents.data(), count);
  const Vec3 across = force - restricted_by(held, force);
  std::array<Vec3, 3> change;  // of parameter i: change[i] . u
  const std::array<Vec3, 3> axes{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};
  for (int axis = 0; axis < 3; ++axis) {
    const std::array<double, 3> share = scene::shares(tangents, axes[static_cast<std::size_t>(axis)]);
    for (std::size_t i = 0; i < count; ++i) change[i][axis] = share[i];
  }
  film::Mat3 block;
  for (int axis = 0; axis < 3; ++axis) {
    const language::Formula& formula = boundary.position[static_cast<std::size_t>(axis)];
    if (!formula) continue;
    const film::Mat3 h = film::symmetric(formula.hessian({held.parameters, scene_.time, {}}).hessian);
    const std::array<Vec3, 3> row{h.x, h.y, h.z};
    for (std::size_t i = 0; i < count; ++i) {
      for (std::size_t j = 0; j < count; ++j)
        block -= across[axis] * row[i][static_cast<int>(j)] * film::outer(change[i], change[j]);
    }
  }
  return block;
}

bool VertexConstraints::project(std::span<Vec3> x) {
  bool all = true;
  for (Held& held : held_) {
    Vec3& at = x[held.vertex];
    if (held.boundary == 0) {
      if (held.fixed) continue;
      all = scene::project_to_level_sets(scene_, held.level_sets, held.vertex, at) && all;
      continue;
    }
    const scene::Boundary& boundary = scene_.boundaries.at(held.boundary);
    const bool found = held.fixed || scene::nearest_parameters(scene_, boundary, at, held.parameters);
    all = all && found;
    if (found) at = scene::boundary_position(scene_, boundary, held.parameters);
  }
  return all;
}

void VertexConstraints::publish(scene::Scene& scene) const {
  for (const Held& held : held_) {
    if (held.boundary != 0) scene::set_boundary_parameters(scene, film::Vertex(held.vertex), held.parameters);
  }
}

double VertexConstraints::violation(std::span<const Vec3> x) const {
  double worst = 0;
  for (const Held& held : held_) {
    const Vec3& at = x[held.vertex];
    if (held.boundary != 0) {
      std::array<double, 3> parameters = held.parameters;
      const scene::Boundary& boundary = scene_.boundaries.at(held.boundary);
      if (!held.fixed) scene::nearest_parameters(scene_, boundary, at, parameters);
      worst = std::max(worst, length(at - scene::boundary_position(scene_, boundary, parameters)));
    }
    for (const int number : held.level_sets) {
      const LevelSet& set = scene_.level_sets.at(number);
      const scene::Level level = scene::level_at(scene_, set, at, held.vertex);
      const bool wrong = set.sense == Sense::equal || (set.sense == Sense::nonnegative && level.value < 0) ||
                         (set.sense == Sense::nonpositive && level.value > 0);
      if (wrong) worst = std::max(worst, std::abs(level.value) / std::max(length(level.gradient), 1e-300));
    }
  }
  return worst;
}

}  // namespace lamella::energy
