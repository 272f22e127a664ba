#include "solve/newton.h"

#include <algorithm>
#include <cmath>

namespace lamella::solve {

namespace {

constexpr double armijo = 1e-4;
constexpr int most_trials = 30;
// The first shift tried, in units of NewtonSystem::scale, and how it grows.
constexpr double first_shift = 0.1;
constexpr double shift_growth = 5;
constexpr int most_shifts = 20;
// An old factorisation serves while each step with it leaves less than this part of the residual.
constexpr double worth_it = 0.3;
// The inertia of a factorisation this near to the equilibrium is that of the equilibrium.
constexpr double near_enough = 3e-5;
// Sums over a film are known to about this part of the energy: smaller differences say nothing.
constexpr double rounding = 1e-13;

}  // namespace

Newton::Newton(Problem& problem, const film::Film& film, MotionKind motion, SymbolicMemory* memory)
    : problem_(problem),
      system_(problem, film, motion, memory),
      reduced_(system_.basis().size()),
      from_(film.vertex_rows()),
      direction_(film.vertex_rows()) {}

void Newton::remember(std::span<const Vec3> x) {
  std::copy(x.begin(), x.end(), from_.begin());
  parameters_from_.assign(problem_.parameters().values().begin(), problem_.parameters().values().end());
}

bool Newton::find_direction(std::span<const Vec3> x, SaddlePolicy policy, NewtonStep& result) {
  bool ok = false;
  result.energy = system_.linearise(x, ok);
  result.area = problem_.energy().area();
  if (!ok) {
    result.ending = std::isfinite(result.energy) ? Ending::volume_lost : Ending::not_finite;
    return false;
  }
  remember(x);
  bool sound = system_.factorise(0);
  result.negative_modes = sound ? system_.negative_modes() : 0;
  slope_ = sound ? system_.step(reduced_) : 0;
  sound = sound && std::isfinite(slope_);
  const bool wanted = sound && (result.negative_modes == 0 || policy == SaddlePolicy::keep);
  if (!wanted && !shift_until_definite(result)) {
    result.ending = Ending::stuck;
    return false;
  }
  result.residual = slope_ == 0 ? 0 : -0.5 * slope_ / std::abs(result.energy);
  if (!std::isfinite(result.residual)) {
    result.ending = Ending::not_finite;
    return false;
  }
  last_residual_ = result.residual;
  system_.basis().expand(reduced_, direction_);
  return true;
}

bool Newton::shift_until_definite(NewtonStep& result) {
  double shift = std::max(first_shift * system_.scale(), last_shift_ / (shift_growth * shift_growth));
  for (int i = 0; i < most_shifts; ++i, shift *= shift_growth) {
    if (!system_.factorise(shift) || system_.negative_modes() > 0) continue;
    slope_ = system_.step(reduced_);
    if (!std::isfinite(slope_)) continue;
    result.shift = last_shift_ = shift;
    return true;
  }
  return false;
}

// Leaves x at a part of the step, volumes restored.
bool Newton::try_fraction(std::span<Vec3> x, double fraction, double& energy) {
  for (std::size_t v = 0; v < x.size(); ++v) x[v] = from_[v] + fraction * direction_[v];
  if (!parameters_from_.empty())
    problem_.set_parameters(parameters_from_, fraction, system_.parameter_step());
  const Ending ending = problem_.restore_volumes(x, energy, RestoreMode::same_gradients);
  return ending == Ending::converged && std::isfinite(energy);
}

// The model's change of energy is (t - t^2/2) times the slope.
bool Newton::search(std::span<Vec3> x, bool uphill, NewtonStep& result) {
  const double start = result.energy;
  const double noise = rounding * std::abs(start);
  double t = 1;
  for (int trial = 0; trial < most_trials; ++trial) {
    double energy = start;
    const bool restored = try_fraction(x, t, energy);
    const double surprise = energy - start - (t - t * t / 2) * slope_;
    const bool fair = uphill ? std::abs(surprise) <= noise + 0.5 * t * std::abs(slope_)
                             : energy <= start + noise + armijo * t * slope_;
    if (restored && fair) {
      result.fraction = t;
      return true;
    }
    const double bend = restored ? energy - start - t * slope_ : HUGE_VAL;
    const double wanted = bend > 0 && std::isfinite(bend) ? -0.5 * slope_ * t * t / bend : 0;
    t = std::clamp(wanted, 0.1 * t, 0.5 * t);
  }
  return false;
}

void Newton::finish(std::span<Vec3> x, NewtonStep& result) {
  if (result.fraction == 0) {
    std::copy(from_.begin(), from_.end(), x.begin());
    if (!parameters_from_.empty()) problem_.set_parameters(parameters_from_);
  }
  result.energy = problem_.energy().value(x);
  result.area = problem_.energy().area();
}

NewtonStep Newton::step(std::span<Vec3> x, SaddlePolicy policy) {
  NewtonStep result;
  if (!find_direction(x, policy, result)) return result;
  const bool uphill = policy == SaddlePolicy::keep && result.negative_modes > 0 && result.shift == 0;
  if (!search(x, uphill, result)) result.ending = Ending::stuck;
  finish(x, result);
  return result;
}

NewtonStep Newton::step_again(std::span<Vec3> x) {
  NewtonStep result;
  bool ok = false;
  result.energy = system_.linearise_nearby(x, ok);
  result.area = problem_.energy().area();
  result.ending = Ending::stuck;
  if (!ok) return result;
  remember(x);
  slope_ = system_.step(reduced_);
  result.residual = -0.5 * slope_ / std::abs(result.energy);
  if (!(std::abs(result.residual) < worth_it * std::abs(last_residual_))) return result;
  system_.basis().expand(reduced_, direction_);
  if (search(x, result.residual < 0, result)) {
    result.ending = Ending::step_limit;
    last_residual_ = result.residual;
  }
  finish(x, result);
  return result;
}

NewtonStep Newton::look(std::span<const Vec3> x) {
  NewtonStep result;
  find_direction(x, SaddlePolicy::keep, result);
  return result;
}

// Halves the step until the energy falls below that at 0, then closes in on the lowest point between half and
// twice of it by parabolas through what is known.
NewtonStep Newton::seek(std::span<Vec3> x, double longest) {
  NewtonStep result;
  if (!find_direction(x, SaddlePolicy::keep, result)) return result;
  const double start = result.energy;
  double t = slope_ <= 0 ? longest : -longest;
  double energy = start;
  const double least = 1e-6 * longest;
  while (std::abs(t) > least && !(try_fraction(x, t, energy) && energy < start)) t /= 2;
  if (std::abs(t) <= least) {
    result.ending = std::abs(result.residual) < rounding ? Ending::converged : Ending::stuck;
    finish(x, result);
    return result;
  }
  for (int i = 0; i < 4; ++i) {
    const double bend = energy - start - t * slope_;
    const double wanted = bend > 0 ? -0.5 * slope_ * t * t / bend : 2 * t;
    const double sign = t < 0 ? -1 : 1;
    const double next =
        sign * std::clamp(std::abs(wanted), 0.5 * std::abs(t), std::min(2 * std::abs(t), longest));
    if (std::abs(next - t) < 1e-3 * std::abs(t)) break;
    double there = energy;
    if (!try_fraction(x, next, there) || there >= energy) break;
    t = next;
    energy = there;
  }
  try_fraction(x, t, energy);
  result.fraction = t;
  finish(x, result);
  return result;
}

namespace {

// The inertia of the last factorisation, or of a new one where that was made too far away or shifted.
Stability stability_at_end(Newton& method, std::span<const Vec3> x, const NewtonStep& factorised) {
  const bool near = std::abs(factorised.residual) < near_enough && factorised.shift == 0;
  if (near && factorised.negative_modes == 0) return {true, 0, 0};
  bool ok = false;
  method.system().linearise(x, ok);
  return ok ? stability(method.system()) : Stability{};
}

}  // namespace

NewtonReport newton(Newton& method, std::span<Vec3> x, const NewtonOptions& options,
                    scene::Monitor& monitor) {
  NewtonReport report;
  report.ending = Ending::step_limit;
  SaddlePolicy policy = options.saddle;
  NewtonStep factorised;
  bool again = false;
  while (report.steps < options.most_steps) {
    NewtonStep step;
    if (again) step = method.step_again(x);
    again = again && step.ending == Ending::step_limit;
    if (!again) factorised = step = method.step(x, policy);
    report.energy = step.energy;
    report.residual = step.residual;
    if (step.ending != Ending::step_limit) {
      report.ending = step.ending;
      break;
    }
    ++report.steps;
    monitor.progress(report.steps, options.most_steps, step.energy);
    if (std::abs(step.residual) < options.tolerance && step.fraction == 1) {
      if (factorised.shift != 0 && policy == SaddlePolicy::shift) {
        policy = SaddlePolicy::keep;
        again = false;
        continue;
      }
      report.ending = Ending::converged;
      report.stability = stability_at_end(method, x, factorised);
      break;
    }
    again = step.fraction == 1 && factorised.shift == 0;
    if (monitor.stop_requested()) {
      report.ending = Ending::stopped;
      break;
    }
  }
  return report;
}

}  // namespace lamella::solve
