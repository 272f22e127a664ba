#include "solve/descent.h"

#include <algorithm>
#include <cmath>

namespace lamella::solve {

namespace {

constexpr int most_halvings = 40;
constexpr int most_doublings = 60;
constexpr double forgotten = 1e-3;

}  // namespace

double first_scale(const Problem& problem) {
  double stiffest = 0;
  for (const energy::VertexLine& line : problem.energy().lines())
    stiffest = std::max(stiffest, line.stiffness);
  return stiffest > 0 ? 1 / stiffest : 0;
}

Descent::Descent(Problem& problem, DescentRule rule)
    : problem_(problem), rule_(rule), from_(problem.vertex_count()), direction_(problem.vertex_count()) {
  if (rule_ == DescentRule::steepest) return;
  force_.resize(problem.vertex_count());
  last_force_.resize(problem.vertex_count());
}

// Adds what is left of the last direction to the force, of the given square, and leaves the sum as the new
// direction. Returns minus the slope along it.
double Descent::conjugate(double squared) {
  double change = 0;
  for (std::size_t v = 0; v < force_.size(); ++v) change += dot(force_[v], force_[v] - last_force_[v]);
  const double beta = last_squared_ > 0 ? std::max(0.0, change / last_squared_) : 0;
  problem_.project(direction_);
  double slope = 0;
  for (std::size_t v = 0; v < force_.size(); ++v) {
    direction_[v] = force_[v] + beta * direction_[v];
    slope += dot(force_[v], direction_[v]);
  }
  if (!(slope > 0)) {
    direction_ = force_;
    slope = squared;
  }
  std::swap(last_force_, force_);
  last_squared_ = squared;
  return slope;
}

void Descent::place(std::span<Vec3> x, double scale) const {
  for (std::size_t v = 0; v < from_.size(); ++v) x[v] = from_[v] + scale * direction_[v];
  problem_.constrain(x);
}

DescentStep Descent::step(std::span<Vec3> x, double& scale, bool fixed, double limit) {
  bool ok = false;
  const double energy = problem_.linearise(x, ok);
  if (!ok)
    return {std::isfinite(energy) ? Ending::volume_lost : Ending::not_finite, energy,
            problem_.energy().area()};
  std::copy(x.begin(), x.end(), from_.begin());
  const bool steepest = rule_ == DescentRule::steepest;
  const double steep = problem_.descent_direction(steepest ? direction_ : force_);
  const double squared = steepest ? steep : conjugate(steep);
  if (!std::isfinite(squared)) return {Ending::not_finite, energy, problem_.energy().area()};
  const double start = problem_.merit(x);
  if (fixed) {
    place(x, scale);
    return finish(x, scale, squared, start);
  }
  // A scale far below what the film stands is left from an equilibrium, where rounding decides.
  if (!(scale > forgotten * first_scale(problem_))) scale = first_scale(problem_);
  scale = std::min(scale, limit);
  bool found = squared != 0 && search(x, start, scale, limit);
  if (!found && !steepest && squared != 0) {
    // Conjugate to a past that no longer counts: begin anew.
    direction_ = last_force_;
    scale = std::min(first_scale(problem_), limit);
    found = search(x, start, scale, limit);
  }
  if (!found) {
    place(x, 0);
    DescentStep none = finish(x, 0, squared, start);
    if (none.ending == Ending::step_limit) none.ending = squared == 0 ? Ending::converged : Ending::stuck;
    return none;
  }
  return finish(x, scale, squared, start);
}

// Leaves x at the accepted scale. From the last one it is doubled as long as that lowers the merit, or halved
// until it does; then comes the parabola through the merits at 0, at the best scale and at twice that.
bool Descent::search(std::span<Vec3> x, double start, double& scale, double limit) {
  const auto merit_at = [&](double trial) {
    place(x, trial);
    return problem_.merit(x);
  };
  double here = merit_at(scale);
  double twice = HUGE_VAL;
  if (here < start) {
    for (int doubling = 0; doubling < most_doublings; ++doubling) {
      twice = merit_at(2 * scale);
      if (!(twice < here) || 2 * scale > limit) break;
      scale *= 2;
      here = twice;
    }
  } else {
    for (int halving = 0; !(here < start); ++halving) {
      if (halving == most_halvings) return false;
      twice = here;
      scale /= 2;
      here = merit_at(scale);
    }
  }
  const double bend = start - 2 * here + twice;
  double optimum = scale;
  if (std::isfinite(bend) && bend > 0) optimum = 0.5 * scale * (3 * start - 4 * here + twice) / bend;
  optimum = std::min(optimum, limit);
  if (optimum == scale || !(merit_at(optimum) < start)) {
    place(x, scale);
  } else {
    scale = optimum;
  }
  return true;
}

DescentStep Descent::finish(std::span<Vec3> x, double scale, double squared, double start) {
  DescentStep result;
  result.scale = scale;
  result.predicted_gain = 0.5 * scale * squared;
  const Ending restored = problem_.restore_volumes(x, result.energy);
  result.area = problem_.energy().area();
  if (restored != Ending::converged) {
    result.ending = restored;
    result.energy = start;
    std::copy(from_.begin(), from_.end(), x.begin());
  }
  return result;
}

}  // namespace lamella::solve
