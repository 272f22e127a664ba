#include "evolution/implicit.h"

#include <algorithm>
#include <cmath>

namespace lamella::evolution {

namespace {

constexpr int most_iterations = 30;
constexpr double accurate = 1e-11;  // of the width of a facet: the last change of a move
constexpr double most_rate = 0.9;   // by which changes have to shrink
constexpr int most_renewals = 4;    // of the Hessian in one step

}  // namespace

ImplicitSolver::ImplicitSolver(const scene::Scene& scene, std::span<const double> masses)
    : scene_(scene),
      problem_(scene_),
      system_(problem_, scene_.film, solve::MotionKind::full),
      masses_(masses),
      at_(masses.size()),
      field_(masses.size()),
      right_(system_.hessian().unknowns() + system_.hessian().constraints()) {}

// Energy, gradients and the factors of [H + shift m, G^T; G, 0] at x.
bool ImplicitSolver::linearise(std::span<const Vec3> x, double time, double shift) {
  problem_.energy().set_time(time);
  bool ok = false;
  system_.linearise(x, ok);
  if (!ok) return false;
  system_.hessian().set_mass(masses_, system_.basis());
  return system_.factorise(shift);
}

// The first rows of the right-hand side: force + m (per_push f + per_velocity v + per_move u).
void ImplicitSolver::add_inertia(const ImplicitStart& start, double per_push, double per_velocity,
                                 double per_move, std::span<const Vec3> moves) {
  problem_.descent_direction(field_);
  for (std::size_t i = 0; i < field_.size(); ++i) {
    Vec3 sum = per_velocity * start.v[i] + per_move * moves[i];
    if (!start.pushes.empty()) sum += per_push * start.pushes[i];
    field_[i] += masses_[i] * sum;
  }
  system_.basis().reduce(field_, std::span(right_).first(system_.hessian().unknowns()));
}

bool ImplicitSolver::euler(const ImplicitStart& start, std::span<Vec3> moves, std::span<double> pressures) {
  const double dt = start.dt;
  system_.hessian().take_convex(true);
  if (!linearise(start.x, start.time, 1 / (dt * dt))) return false;
  std::fill(moves.begin(), moves.end(), Vec3{});
  add_inertia(start, 1, 1 / dt, 0, moves);
  const std::size_t unknowns = system_.hessian().unknowns();
  for (std::size_t i = 0; i < pressures.size(); ++i) {
    const film::Region region = problem_.energy().constrained()[i];
    right_[unknowns + i] = start.targets[i] - problem_.energy().volumes()[region.index];
  }
  if (!std::isfinite(take_step(moves))) return false;
  for (std::size_t i = 0; i < pressures.size(); ++i)
    pressures[i] = problem_.pressures()[i] - right_[unknowns + i];
  return true;
}

// Adds the solution of the system to the moves; returns the largest change.
double ImplicitSolver::take_step(std::span<Vec3> moves) {
  system_.solve(right_, 1);
  system_.basis().expand(std::span(right_).first(system_.hessian().unknowns()), field_);
  double largest = 0;
  for (std::size_t i = 0; i < moves.size(); ++i) {
    moves[i] += field_[i];
    const double change = squared_length(field_[i]);
    largest = change <= largest ? largest : change;  // what is not a number stays
  }
  return std::sqrt(largest);
}

bool ImplicitSolver::midpoint(const ImplicitStart& start, std::span<Vec3> moves,
                              std::span<double> pressures) {
  const double dt = start.dt;
  const std::size_t unknowns = system_.hessian().unknowns();
  for (std::size_t i = 0; i < moves.size(); ++i) {
    moves[i] = dt * start.v[i];
    at_[i] = start.x[i] + 0.5 * moves[i];
  }
  if (!linearise(at_, start.time + 0.5 * dt, 4 / (dt * dt))) return false;
  const double width = std::sqrt(problem_.energy().area() / static_cast<double>(moves.size() + 1));
  double before = HUGE_VAL;
  int renewals = 0;
  for (int iteration = 0; iteration < most_iterations; ++iteration) {
    for (std::size_t i = 0; i < moves.size(); ++i) at_[i] = start.x[i] + moves[i];
    problem_.energy().set_time(start.time + dt);
    problem_.energy().value(at_);
    for (std::size_t i = 0; i < pressures.size(); ++i) {
      const film::Region region = problem_.energy().constrained()[i];
      right_[unknowns + i] = start.targets[i] - problem_.energy().volumes()[region.index];
    }
    for (std::size_t i = 0; i < moves.size(); ++i) at_[i] = start.x[i] + 0.5 * moves[i];
    problem_.energy().set_time(start.time + 0.5 * dt);
    bool ok = false;
    problem_.linearise(at_, ok);
    if (!ok) return false;
    add_inertia(start, 1, 2 / dt, -2 / (dt * dt), moves);
    for (std::size_t i = 0; i < unknowns; ++i) right_[i] *= 2;
    const double change = take_step(moves);
    for (std::size_t i = 0; i < pressures.size(); ++i)
      pressures[i] = problem_.pressures()[i] - 0.5 * right_[unknowns + i];
    if (change < accurate * width) return true;
    before = change < most_rate * before ? change : HUGE_VAL;
    if (before < HUGE_VAL) continue;
    // The Hessian has become another one.
    if (++renewals > most_renewals || !std::isfinite(change)) return false;
    for (std::size_t i = 0; i < moves.size(); ++i) at_[i] = start.x[i] + 0.5 * moves[i];
    if (!linearise(at_, start.time + 0.5 * dt, 4 / (dt * dt))) return false;
  }
  return false;
}

}  // namespace lamella::evolution
