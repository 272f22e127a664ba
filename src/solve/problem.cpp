#include "solve/problem.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "energy/volume_products.h"
#include "film/blocks.h"

namespace lamella::solve {

namespace {

constexpr double finest_tolerance = 1e-13;  // relative; a few times rounding for a hundred thousand facets
constexpr int most_passes = 200;
constexpr int most_rough_passes = 10;
// Most that one pass may change a volume by, of itself. Gradients at the start of a pass point where the film
// stood.
constexpr double most_shrinking = 0.2;
constexpr double most_growth = 0.25;

std::vector<double> inverse_masses(const film::Film& film) {
  const std::span<const std::uint8_t> fixed = film.columns(film::ElementKind::vertex).flags("fixed");
  std::vector<double> weights(film.vertex_rows(), 1.0);
  for (std::size_t v = 0; v < fixed.size(); ++v) {
    if (fixed[v] != 0) weights[v] = 0;
  }
  return weights;
}

// Far from the origin positions are rounded more coarsely, and a sphere's volume with them.
double tolerance_of(std::span<const Vec3> positions, std::span<const double> volumes) {
  double far = 0;
  for (const Vec3& p : positions) far = std::max({far, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  double tolerance = finest_tolerance;
  for (const double volume : volumes) tolerance = std::max(tolerance, 20 * 2.2e-16 * far / std::cbrt(volume));
  return tolerance;
}

}  // namespace

std::string_view describe(Ending ending) {
  switch (ending) {
    case Ending::converged:
      return "converged";
    case Ending::step_limit:
      return "step limit reached";
    case Ending::stopped:
      return "stopped";
    case Ending::stuck:
      return "stuck: no step lowers the energy";
    case Ending::not_finite:
      return "a number is no longer finite";
    case Ending::volume_lost:
      return "the volumes cannot be brought to their targets";
    case Ending::collapsed:
      return "no equilibrium found: the film collapses";
    case Ending::tangled:
      return "films would pass through one another, however small the steps";
    case Ending::constraint_lost:
      return "vertices cannot be brought onto their constraints";
  }
  return "";
}

Problem::Problem(const scene::Scene& scene)
    : energy_(scene),
      parameters_(scene),
      weights_(inverse_masses(scene.film)),
      gram_(energy_.volume_gradient().rows(), energy_.volume_gradient().pattern()) {
  const std::size_t rows = energy_.held_values().size();
  targets_.resize(rows);
  volume_scale_.resize(rows);
  pressures_.resize(rows);
  errors_.resize(rows);
  multipliers_.resize(rows);
  set_targets(scene);
}

void Problem::set_targets(const scene::Scene& scene) {
  const std::size_t bodies = energy_.constrained().size();
  for (std::size_t i = 0; i < bodies; ++i) {
    targets_[i] = *scene.body(energy_.constrained()[i]).target_volume;
    volume_scale_[i] = std::max(std::abs(targets_[i]), 1e-300);
  }
  volume_tolerance_ = tolerance_of(scene.film.positions(), {volume_scale_.data(), bodies});
  const std::span<const Vec3> positions = scene.film.positions();
  if (energy_.fixed().empty()) return;
  energy_.value(positions);
  for (std::size_t i = bodies; i < targets_.size(); ++i) {
    const scene::Quantity& quantity = scene.quantities[energy_.fixed()[i - bodies]];
    const bool fixed = quantity.role == scene::QuantityRole::fixed;
    targets_[i] = fixed ? quantity.target : energy_.held_values()[i];
    volume_scale_[i] =
        std::max({std::abs(targets_[i]), energy_.size_of_fixed(i - bodies, positions), 1e-300});
  }
}

// The Gram matrix of what is held, and its products with the gradient of the energy, in one pass.
bool Problem::factorise() {
  const std::span<const energy::VertexLine> lines = energy_.lines();
  const auto fields = [&](std::size_t v) {
    return energy::VolumeGradient::Fields{weights_[v] * energy::lane_at(&lines[v].gradient.x), {}, 0};
  };
  energy::multiply_all(energy_.volume_gradient(), weights_, fields, products_);
  return gram_.factorise(products_.gram) && (parameters_.empty() || factorise_parameters());
}

bool Problem::factorise_parameters() {
  const std::size_t count = parameters_.size();
  const std::size_t held = targets_.size();
  const auto at = [](std::size_t i) { return static_cast<Eigen::Index>(i); };
  solved_slopes_.resize(count * held);
  Eigen::MatrixXd small(at(count), at(count));
  for (std::size_t k = 0; k < count; ++k) {
    const std::span<double> column(solved_slopes_.data() + k * held, held);
    for (std::size_t i = 0; i < held; ++i) errors_[i] = parameters_.held_slope(k, i);
    gram_.solve(errors_, column);
    for (std::size_t l = 0; l < count; ++l) {
      double sum = k == l ? 1 / parameters_.scale(k) : 0;
      for (std::size_t i = 0; i < held; ++i) sum += parameters_.held_slope(l, i) * column[i];
      small(at(l), at(k)) = sum;
    }
  }
  const Eigen::MatrixXd inverse = small.inverse();
  small_inverse_.assign(inverse.data(), inverse.data() + inverse.size());
  return inverse.allFinite();
}

void Problem::solve_gram(std::span<const double> right, std::span<double> result) const {
  gram_.solve(right, result);
  const std::size_t count = parameters_.size();
  if (count == 0) return;
  const std::size_t held = targets_.size();
  std::vector<double> part(count);
  for (std::size_t k = 0; k < count; ++k) {
    for (std::size_t i = 0; i < held; ++i) part[k] += parameters_.held_slope(k, i) * result[i];
  }
  for (std::size_t k = 0; k < count; ++k) {
    double times = 0;
    for (std::size_t l = 0; l < count; ++l) times += small_inverse_[l * count + k] * part[l];
    for (std::size_t i = 0; i < held; ++i) result[i] -= times * solved_slopes_[k * held + i];
  }
}

double Problem::linearise(std::span<const Vec3> x, bool& ok) {
  ok = parameters_.empty() || parameters_.differentiate(energy_, x);
  if (!ok) return NAN;
  const double energy = energy_.gradient(x);
  ok = std::isfinite(energy);
  if (!ok) return energy;
  ok = find_pressures();
  if (!ok || !energy_.constraints().touched()) return energy;
  let_go(x);
  ok = find_pressures();
  return energy;
}

// One-sided constraints that the force, by the present pressures, pulls away from; pressures are to follow.
void Problem::let_go(std::span<const Vec3> x) {
  force_.resize(x.size());
  energy_.volume_gradient().set_multipliers(pressures_);
  film::for_each_block(force_.size(), [&](std::size_t first, std::size_t last) {
    for (std::size_t v = first; v < last; ++v) force_[v] = force(v);
  });
  energy_.renew_constraints(x, force_);
}

bool Problem::find_pressures() {
  if (targets_.empty()) return true;
  if (!factorise()) return false;
  std::copy(products_.first.begin(), products_.first.end(), errors_.begin());
  for (std::size_t k = 0; k < parameters_.size(); ++k) {
    const double way = parameters_.scale(k) * parameters_.slope(k);
    for (std::size_t i = 0; i < errors_.size(); ++i) errors_[i] += way * parameters_.held_slope(k, i);
  }
  solve_gram(errors_, pressures_);
  return true;
}

bool Problem::constrain(std::span<Vec3> x) {
  return energy_.constraints().empty() || energy_.constraints().project(x);
}

double Problem::descent_direction(std::span<Vec3> direction) {
  const std::span<const energy::VertexLine> lines = energy_.lines();
  energy::VolumeGradient& volume = energy_.volume_gradient();
  volume.set_multipliers(pressures_);
  const energy::VertexConstraints& constraints = energy_.constraints();
  double squared = film::sum_of_blocks(direction.size(), [&](std::size_t first, std::size_t last) {
    double sum = 0;
    for (std::size_t v = first; v < last; ++v) {
      Vec3 force = targets_.empty() ? -lines[v].gradient : volume.pull(v) - lines[v].gradient;
      if (!constraints.empty()) force = constraints.restricted(static_cast<std::uint32_t>(v), force);
      direction[v] = weights_[v] * force;
      sum += squared_length(direction[v]);
    }
    return sum;
  });
  parameter_direction_.resize(parameters_.size());
  for (std::size_t k = 0; k < parameters_.size(); ++k) {
    double force = -parameters_.slope(k);
    for (std::size_t i = 0; i < targets_.size(); ++i) force += pressures_[i] * parameters_.held_slope(k, i);
    parameter_direction_[k] = parameters_.scale(k) * force;
    squared += parameters_.scale(k) * force * force;
  }
  return squared;
}

bool Problem::force_at(std::span<const Vec3> x, std::span<Vec3> field) {
  const bool ok = std::isfinite(energy_.gradient(x));
  if (energy_.constraints().touched()) let_go(x);
  energy_.volume_gradient().set_multipliers(pressures_);
  for (std::size_t v = 0; v < field.size(); ++v) field[v] = weights_[v] * force(v);
  energy_.constraints().restrict(field);
  return ok;
}

Vec3 Problem::force(std::size_t vertex) const {
  const Vec3 pull = targets_.empty() ? Vec3{} : energy_.volume_gradient().unrestricted_pull(vertex);
  return pull - energy_.lines()[vertex].gradient;
}

void Problem::project(std::span<Vec3> field) {
  for (std::size_t v = 0; v < field.size(); ++v) field[v] *= weights_[v];
  energy_.constraints().restrict(field);
  if (targets_.empty()) return;
  energy_.volume_gradient().dot(weights_, field, errors_);
  gram_.solve(errors_, multipliers_);
  energy_.volume_gradient().set_multipliers(multipliers_);
  for (std::size_t v = 0; v < field.size(); ++v) field[v] -= weights_[v] * energy_.volume_gradient().pull(v);
}

void Problem::volume_errors(std::span<double> errors) const {
  for (std::size_t i = 0; i < targets_.size(); ++i) errors[i] = targets_[i] - energy_.held_values()[i];
}

double Problem::merit(std::span<const Vec3> x) {
  double result = energy_.value(x);
  for (std::size_t i = 0; i < targets_.size(); ++i)
    result -= pressures_[i] * (energy_.held_values()[i] - targets_[i]);
  return result;
}

double Problem::volume_error() const {
  double worst = 0;
  for (std::size_t i = 0; i < targets_.size(); ++i) {
    const double error = targets_[i] - energy_.held_values()[i];
    worst = std::max(worst, std::abs(error) / volume_scale_[i]);
  }
  return worst;
}

// By the multipliers, as vertices do.
void Problem::move_parameters() {
  std::vector<double> values(parameters_.values().begin(), parameters_.values().end());
  for (std::size_t k = 0; k < values.size(); ++k) {
    for (std::size_t i = 0; i < targets_.size(); ++i)
      values[k] += parameters_.scale(k) * multipliers_[i] * parameters_.held_slope(k, i);
  }
  set_parameters(values);
}

// Moves x along the volume gradients by what volumes lack to first order. False if it leaves its constraints.
bool Problem::make_good(std::span<Vec3> x, std::span<const double> errors) {
  solve_gram(errors, multipliers_);
  if (!parameters_.empty()) move_parameters();
  energy_.volume_gradient().set_multipliers(multipliers_);
  const energy::VolumeGradient& volume = energy_.volume_gradient();
  film::for_each_block(x.size(), [&](std::size_t first, std::size_t last) {
    for (std::size_t v = first; v < last; ++v) x[v] += weights_[v] * volume.pull(v);
  });
  return constrain(x);
}

Ending Problem::linearise_and_restore(std::span<Vec3> x, double& energy) {
  bool ok = false;
  linearise(x, ok);
  return ok ? restore_volumes(x, energy) : Ending::volume_lost;
}

Ending Problem::restore_volumes(std::span<Vec3> x, double& energy, RestoreMode mode) {
  if (!constrain(x)) return Ending::constraint_lost;
  if (targets_.empty()) {
    energy = energy_.value(x);
    return std::isfinite(energy) ? Ending::converged : Ending::not_finite;
  }
  double before = HUGE_VAL;
  for (int pass = 0; pass < most_passes; ++pass) {
    energy = energy_.value(x);
    const double error = volume_error();
    if (!std::isfinite(energy) || !std::isfinite(error)) return Ending::not_finite;
    if (error < volume_tolerance_ || (error < 100 * volume_tolerance_ && error > 0.5 * before))
      return Ending::converged;
    if (error > 0.1 * before) {
      if (mode == RestoreMode::same_gradients) return Ending::volume_lost;
      bool ok = false;
      linearise(x, ok);
      if (!ok) return Ending::volume_lost;
    }
    before = error;
    volume_errors(errors_);
    limit(errors_);
    if (!make_good(x, errors_)) return Ending::constraint_lost;
  }
  return volume_error() < 1e-9 ? Ending::converged : Ending::volume_lost;
}

double Problem::restore_roughly(std::span<Vec3> x, double tolerance) {
  if (!constrain(x)) return HUGE_VAL;
  return restore_roughly(x, tolerance, energy_.value(x));
}

double Problem::restore_roughly(std::span<Vec3> x, double tolerance, double energy) {
  for (int pass = 0; pass < most_rough_passes && !targets_.empty(); ++pass) {
    volume_errors(errors_);
    const bool near = std::all_of(errors_.begin(), errors_.end(),
                                  [&](double error) { return std::abs(error) <= tolerance; });
    if ((near && pass > 0) || !std::isfinite(energy)) break;
    if (!make_good(x, errors_)) return HUGE_VAL;
    energy = energy_.value(x);
  }
  return energy;
}

void Problem::limit(std::span<double> errors) const {
  for (std::size_t i = 0; i < energy_.constrained().size(); ++i) {
    const double size = std::max(std::abs(energy_.held_values()[i]), 0.01 * volume_scale_[i]);
    errors[i] = std::clamp(errors[i], -most_shrinking * size, most_growth * size);
  }
}

void Problem::publish(scene::Scene& scene) const {
  if (!energy_.constraints().empty()) energy_.constraints().publish(scene);
  parameters_.publish(scene, parameter_direction_);
  const std::size_t bodies = energy_.constrained().size();
  for (std::size_t i = 0; i < bodies; ++i) scene.body(energy_.constrained()[i]).pressure = pressures_[i];
  for (std::size_t i = bodies; i < targets_.size(); ++i)
    scene.quantities[energy_.fixed()[i - bodies]].pressure = pressures_[i];
}

}  // namespace lamella::solve
