#include "solve/descent.h"

#include <algorithm>
#include <cmath>

#include "film/blocks.h"

namespace lamella::solve {

namespace {

constexpr int most_halvings = 40;
constexpr int most_doublings = 60;
constexpr double least_scale =
    1e-6;  // to begin with: less is left from an equilibrium, where rounding decides
constexpr double volume_tolerance = 1e-4;  // Evolver's target_tolerance
constexpr double hopeless = 0.1;           // of a volume, relative

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
  const double change = film::sum_of_blocks(force_.size(), [&](std::size_t first, std::size_t last) {
    double sum = 0;
    for (std::size_t v = first; v < last; ++v) sum += dot(force_[v], force_[v] - last_force_[v]);
    return sum;
  });
  const double beta = last_squared_ > 0 ? std::max(0.0, change / last_squared_) : 0;
  problem_.project(direction_);
  double slope = film::sum_of_blocks(force_.size(), [&](std::size_t first, std::size_t last) {
    double sum = 0;
    for (std::size_t v = first; v < last; ++v) {
      direction_[v] = force_[v] + beta * direction_[v];
      sum += dot(force_[v], direction_[v]);
    }
    return sum;
  });
  if (!(slope > 0)) {
    direction_ = force_;
    slope = squared;
  }
  std::swap(last_force_, force_);
  last_squared_ = squared;
  return slope;
}

// Moves along the direction and restores volumes about as well as Surface Evolver does. Returns the energy.
double Descent::move(std::span<Vec3> x, double scale) const {
  film::for_each_block(from_.size(), [&](std::size_t first, std::size_t last) {
    for (std::size_t v = first; v < last; ++v) x[v] = from_[v] + scale * direction_[v];
  });
  if (!parameters_from_.empty()) problem_.set_parameters(parameters_from_, scale, parameter_way_);
  return problem_.restore_roughly(x, volume_tolerance);
}

DescentStep Descent::step(std::span<Vec3> x, double& scale, bool fixed, double limit) {
  bool ok = false;
  const double energy = problem_.linearise(x, ok);
  if (!ok)
    return {std::isfinite(energy) ? Ending::volume_lost : Ending::not_finite, energy,
            problem_.energy().area()};
  film::for_each_block(x.size(), [&](std::size_t first, std::size_t last) {
    std::copy(x.data() + first, x.data() + last, from_.data() + first);
  });
  const bool steepest = rule_ == DescentRule::steepest;
  const double steep = problem_.descent_direction(steepest ? direction_ : force_);
  const double squared = steepest ? steep : conjugate(steep);
  parameters_from_.assign(problem_.parameters().values().begin(), problem_.parameters().values().end());
  parameter_way_.assign(problem_.parameter_direction().begin(), problem_.parameter_direction().end());
  if (!std::isfinite(squared)) return {Ending::not_finite, energy, problem_.energy().area()};
  if (fixed) return finish(x, move(x, scale), scale, squared);
  // Projections onto constraints leave their own rounding at every place: energies are compared after one.
  const double start = problem_.energy().constraints().empty() && parameters_from_.empty()
                           ? problem_.restore_roughly(x, volume_tolerance, energy)
                           : move(x, 0);
  scale = std::clamp(scale, least_scale, std::max(limit, least_scale));
  std::optional<double> reached;
  if (squared != 0) reached = search(x, start, scale, limit);
  if (!reached && !steepest && squared != 0) {
    // Conjugate to a past that no longer counts: begin anew.
    direction_ = last_force_;
    scale = std::min(first_scale(problem_), limit);
    reached = search(x, start, scale, limit);
  }
  if (reached) return finish(x, *reached, scale, squared);
  DescentStep none = finish(x, move(x, 0), 0, squared);
  if (none.ending == Ending::step_limit) none.ending = squared == 0 ? Ending::converged : Ending::stuck;
  return none;
}

// Leaves x at the accepted scale and returns the energy there; nothing if none lowers it. From the last scale
// it is doubled as long as that lowers the energy, or halved until it does; then comes the parabola through
// the energies at 0, at the best scale and at twice that.
std::optional<double> Descent::search(std::span<Vec3> x, double start, double& scale, double limit) const {
  double here = move(x, scale);
  double twice = HUGE_VAL;
  if (here < start) {
    for (int doubling = 0; doubling < most_doublings; ++doubling) {
      twice = move(x, 2 * scale);
      if (!(twice < here) || 2 * scale > limit) break;
      scale *= 2;
      here = twice;
    }
  } else {
    for (int halving = 0; !(here < start); ++halving) {
      if (halving == most_halvings) return std::nullopt;
      twice = here;
      scale /= 2;
      here = move(x, scale);
    }
  }
  const double bend = start - 2 * here + twice;
  double optimum = scale;
  if (std::isfinite(bend) && bend > 0) optimum = 0.5 * scale * (3 * start - 4 * here + twice) / bend;
  optimum = std::min(optimum, limit);
  const double energy = move(x, optimum);
  if (energy < start) {
    scale = optimum;
    return energy;
  }
  return move(x, scale);
}

DescentStep Descent::finish(std::span<Vec3> x, double energy, double scale, double squared) const {
  DescentStep result;
  result.energy = energy;
  result.scale = scale;
  result.predicted_gain = 0.5 * scale * squared;
  result.area = problem_.energy().area();
  const bool lost = problem_.volume_error() > hopeless;
  if (std::isfinite(energy) && !lost) return result;
  result.ending = std::isfinite(energy) ? Ending::volume_lost : Ending::not_finite;
  std::copy(from_.begin(), from_.end(), x.begin());
  if (!parameters_from_.empty()) problem_.set_parameters(parameters_from_);
  return result;
}

}  // namespace lamella::solve
