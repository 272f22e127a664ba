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

// Whether a level holds a vertex at which it has this value and gradient, pushed by `force` (null: however).
bool holds_there(const LevelSet& set, const scene::Level& level, const Vec3* force) {
  if (set.sense == Sense::equal) return true;
  const double inward = set.sense == Sense::nonnegative ? 1 : -1;
  const double tolerance = touching * (1 + length(level.gradient));
  if (inward * level.value > tolerance) return false;
  return force == nullptr || inward * dot(*force, level.gradient) <= 0;
}

// Whether a level moves with a parameter that is optimized.
bool moves_with_parameters(const scene::Scene& scene, const LevelSet& set) {
  const auto reads = [&](const scene::FreeParameter& parameter) {
    const auto variables = set.formula.variables();
    return !parameter.fixed &&
           std::find(variables.begin(), variables.end(), parameter.variable) != variables.end();
  };
  return std::any_of(scene.parameters.begin(), scene.parameters.end(), reads);
}

}  // namespace

VertexConstraints::VertexConstraints(const scene::Scene& scene) {
  if (scene.level_sets.empty() && scene.boundaries.empty()) return;
  scene_ = scene;
  scene::bind_formulas(scene_);
  const std::uint32_t vertices = scene.film.vertex_rows();
  index_.assign(vertices, none);
  const auto fixed = scene.film.columns(ElementKind::vertex).flags("fixed");
  std::vector<std::pair<int, std::uint32_t>> singles;
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
        held.follows = held.follows || moves_with_parameters(scene, at->second);
      }
    }
    if (held.boundary == 0 && held.level_sets.empty()) continue;
    if (held.level_sets.size() == 1 && !held.fixed &&
        scene.level_sets.at(held.level_sets[0]).formula.attributes().empty()) {
      singles.emplace_back(held.level_sets[0], v);
      continue;
    }
    index_[v] = static_cast<std::uint32_t>(held_.size());
    held_.push_back(std::move(held));
  }
  add_groups(singles);
  scene_.film.edit_position_rows() = {};
  for (const auto& [number, set] : scene_.level_sets) moves_ = moves_ || set.formula.depends_on_time();
  for (const auto& [number, boundary] : scene_.boundaries) {
    for (const language::Formula& formula : boundary.position) moves_ = moves_ || formula.depends_on_time();
  }
}

void VertexConstraints::set_variables(const language::Variables& variables) {
  scene_.variables = variables;
  scene::bind_formulas(scene_);
}

void VertexConstraints::add_groups(std::vector<std::pair<int, std::uint32_t>>& singles) {
  std::stable_sort(singles.begin(), singles.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  for (const auto& [number, vertex] : singles) {
    if (groups_.empty() || groups_.back().number != number)
      groups_.push_back({number, single_vertices_.size(), single_vertices_.size()});
    index_[vertex] = static_cast<std::uint32_t>(held_.size() + single_vertices_.size());
    single_vertices_.push_back(vertex);
    ++groups_.back().end;
  }
  single_normals_.resize(single_vertices_.size());
}

void VertexConstraints::renew_levels(Held& held, const Vec3& at, const Vec3* force) {
  held.count = 0;
  for (const int number : held.level_sets) {
    if (held.count == 3) break;
    const LevelSet& set = scene_.level_sets.at(number);
    const scene::Level level = scene::level_at(scene_, set, at, held.vertex);
    if (!holds_there(set, level, force)) continue;
    touched_ = touched_ || set.sense != Sense::equal;
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

// Calls function(first, count, points) for up to `lane_count` vertices at a time; lanes without a vertex
// repeat the last one.
template <class Function>
void VertexConstraints::for_each_block(const Group& group, std::span<const Vec3> x,
                                       Function&& function) const {
  constexpr std::size_t lanes = language::lane_count;
  for (std::size_t first = group.begin; first < group.end; first += lanes) {
    const std::size_t count = std::min(lanes, group.end - first);
    Points points;
    for (std::size_t i = 0; i < lanes; ++i) {
      const Vec3& at = x[single_vertices_[first + std::min(i, count - 1)]];
      points[0][i] = at.x;
      points[1][i] = at.y;
      points[2][i] = at.z;
    }
    function(first, count, points);
  }
}

void VertexConstraints::renew(const Group& group, std::span<const Vec3> x, std::span<const Vec3> force) {
  const LevelSet& set = scene_.level_sets.at(group.number);
  for_each_block(group, x, [&](std::size_t first, std::size_t count, const Points& points) {
    const language::First<language::Lanes> levels = set.formula.gradients(points, scene_.time);
    for (std::size_t i = 0; i < count; ++i) {
      const scene::Level level{levels.value[i],
                               {levels.gradient[0][i], levels.gradient[1][i], levels.gradient[2][i]}};
      const Vec3* const push = force.empty() ? nullptr : &force[single_vertices_[first + i]];
      const bool holds = holds_there(set, level, push) && squared_length(level.gradient) > 0;
      single_normals_[first + i] = holds ? unit(level.gradient) : Vec3{};
      touched_ = touched_ || (holds && set.sense != Sense::equal);
    }
  });
}

void VertexConstraints::renew(std::span<const Vec3> x, std::span<const Vec3> force) {
  touched_ = false;
  for (const Group& group : groups_) renew(group, x, force);
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
  for (std::size_t i = 0; i < single_vertices_.size(); ++i) {
    Vec3& at = field[single_vertices_[i]];
    at -= dot(at, single_normals_[i]) * single_normals_[i];
  }
  for (const Held& held : held_) field[held.vertex] = restricted_by(held, field[held.vertex]);
}

int VertexConstraints::forbidden(std::uint32_t row, std::array<Vec3, 3>& directions) const {
  if (row < held_.size()) {
    directions = held_[row].directions;
    return held_[row].count;
  }
  directions[0] = single_normals_[row - held_.size()];
  return squared_length(directions[0]) > 0 ? 1 : 0;
}

int VertexConstraints::allowed(std::uint32_t vertex, std::array<Vec3, 3>& directions) const {
  const std::uint32_t row = index_[vertex];
  if (row < held_.size() && held_[row].boundary != 0) {
    directions = held_[row].directions;
    return held_[row].count;
  }
  // What is left of the axes when the forbidden directions are taken out.
  std::array<Vec3, 3> taken;
  const int taken_count = forbidden(row, taken);
  std::array<Vec3, 6> all;
  std::copy(taken.begin(), taken.end(), all.begin());
  const std::array<Vec3, 3> axes{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};
  int count = 0;
  for (const Vec3& axis : axes) {
    if (count == 3 - taken_count) break;
    Vec3 v = axis;
    for (int i = 0; i < taken_count + count; ++i)
      v -= dot(v, all[static_cast<std::size_t>(i)]) * all[static_cast<std::size_t>(i)];
    if (length(v) < 0.5) continue;  // the others are nearer to what is left
    all[static_cast<std::size_t>(taken_count + count)] = directions[static_cast<std::size_t>(count)] =
        unit(v);
    ++count;
  }
  return count;
}

const VertexConstraints::Group& VertexConstraints::group_of(std::size_t single) const {
  const auto after = std::upper_bound(groups_.begin(), groups_.end(), single,
                                      [](std::size_t row, const Group& group) { return row < group.end; });
  return *after;
}

film::Mat3 VertexConstraints::curvature(std::uint32_t vertex, const Vec3& at, const Vec3& force) const {
  const std::uint32_t row = index_[vertex];
  if (row < held_.size()) {
    const Held& held = held_[row];
    if (held.boundary != 0) return boundary_curvature(held, force);
    return level_curvature(vertex, std::span(held.active.data(), static_cast<std::size_t>(held.active_count)),
                           at, force);
  }
  const std::size_t single = row - held_.size();
  if (squared_length(single_normals_[single]) == 0) return {};
  return level_curvature(vertex, std::array{group_of(single).number}, at, force);
}

// The force across is a sum of gradients; each level's share times its Hessian.
film::Mat3 VertexConstraints::level_curvature(std::uint32_t vertex, std::span<const int> active,
                                              const Vec3& at, const Vec3& force) const {
  std::array<Vec3, 3> gradients;
  std::array<film::Mat3, 3> hessians;
  for (std::size_t i = 0; i < active.size(); ++i) {
    const scene::LevelSet& set = scene_.level_sets.at(active[i]);
    std::vector<double> attributes;
    if (!set.formula.attributes().empty())
      attributes = scene::attributes_of(scene_.film, set.formula, film::ElementKind::vertex, vertex);
    const language::Jet jet = set.formula.hessian({std::array{at.x, at.y, at.z}, scene_.time, attributes});
    gradients[i] = {jet.gradient[0], jet.gradient[1], jet.gradient[2]};
    hessians[i] = film::symmetric(jet.hessian);
  }
  const std::array<double, 3> share = scene::shares(std::span(gradients.data(), active.size()), force);
  film::Mat3 block;
  for (std::size_t i = 0; i < active.size(); ++i) block += share[i] * hessians[i];
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

// As scene::project_to_level_sets does for one level set, lane by lane. Values alone cost a quarter of what
// gradients do, and near the level one gradient serves for several steps: each leaves what the last did times
// the angle by which the level turned on the way.
bool VertexConstraints::project_block(const LevelSet& set, Points& points) const {
  using language::Lanes;
  constexpr int most_steps = 80;
  constexpr double serves = 0.02;  // a gradient, while a step with it leaves no more than this
  constexpr std::size_t lanes = language::lane_count;
  // Where a value of this sign holds nothing.
  const double free_sign = set.sense == Sense::nonnegative ? 1 : set.sense == Sense::nonpositive ? -1 : 0;
  Lanes rounding;
  for (std::size_t i = 0; i < lanes; ++i)
    rounding[i] = 4e-16 * (std::abs(points[0][i]) + std::abs(points[1][i]) + std::abs(points[2][i]) + 1e-300);
  Lanes going;  // 1, or 0 where the point has arrived
  going.fill(1);
  Lanes before;
  before.fill(HUGE_VAL);
  Lanes steepness{};
  std::array<Lanes, 3> slope{};
  bool fresh = true;
  for (int step = 0; step < most_steps; ++step) {
    Lanes value;
    if (fresh) {
      const language::First<Lanes> levels = set.formula.gradients(points, scene_.time);
      value = levels.value;
      slope = levels.gradient;
      for (std::size_t i = 0; i < lanes; ++i)
        steepness[i] =
            std::sqrt(slope[0][i] * slope[0][i] + slope[1][i] * slope[1][i] + slope[2][i] * slope[2][i]) +
            1e-300;
    } else {
      value = set.formula.values(points, scene_.time);
    }
    double left = 0;
    double stale = 0;
    for (std::size_t i = 0; i < lanes; ++i) {
      const double distance = std::abs(value[i]) / steepness[i];
      const bool free = fresh && value[i] * free_sign >= 0 && free_sign != 0;
      const bool stalled = distance < 100 * rounding[i] && distance >= before[i];
      going[i] = distance <= rounding[i] || free || stalled ? 0 : going[i];
      stale += distance > serves * before[i] ? going[i] : 0;
      before[i] = distance;
      left += going[i] * distance;
      const double multiplier = going[i] * -value[i] / (steepness[i] * steepness[i]);
      for (std::size_t k = 0; k < 3; ++k) points[k][i] += multiplier * slope[k][i];
    }
    if (left == 0) return true;
    if (!std::isfinite(left)) return false;
    fresh = !fresh && stale > 0;
  }
  return false;
}

bool VertexConstraints::project(const Group& group, std::span<Vec3> x) const {
  const LevelSet& set = scene_.level_sets.at(group.number);
  bool all = true;
  for_each_block(group, x, [&](std::size_t first, std::size_t count, Points& points) {
    if (set.sense != Sense::equal) {
      const language::Lanes values = set.formula.values(points, scene_.time);
      const bool none_beyond = std::none_of(values.begin(), values.end(), [&](double value) {
        return !std::isfinite(value) || violated(set, value);
      });
      if (none_beyond) return;
    }
    all = project_block(set, points) && all;
    for (std::size_t i = 0; i < count; ++i)
      x[single_vertices_[first + i]] = {points[0][i], points[1][i], points[2][i]};
  });
  return all;
}

bool VertexConstraints::project(std::span<Vec3> x) {
  bool all = true;
  for (const Group& group : groups_) all = project(group, x) && all;
  for (Held& held : held_) {
    Vec3& at = x[held.vertex];
    if (held.boundary == 0) {
      if (held.fixed && !held.follows) continue;
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
  for (const Group& group : groups_) {
    const LevelSet& set = scene_.level_sets.at(group.number);
    for (std::size_t i = group.begin; i < group.end; ++i) {
      const std::uint32_t vertex = single_vertices_[i];
      const scene::Level level = scene::level_at(scene_, set, x[vertex], vertex);
      if (violated(set, level.value))
        worst = std::max(worst, std::abs(level.value) / std::max(length(level.gradient), 1e-300));
    }
  }
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
      if (violated(set, level.value))
        worst = std::max(worst, std::abs(level.value) / std::max(length(level.gradient), 1e-300));
    }
  }
  return worst;
}

}  // namespace lamella::energy
