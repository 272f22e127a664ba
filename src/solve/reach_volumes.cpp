#include "solve/reach_volumes.h"

#include <algorithm>
#include <cmath>

#include "solve/film_metric.h"

namespace lamella::solve {

namespace {

constexpr int most_steps = 200;
constexpr double small_error = 0.02;  // relative; from here on volume gradients serve
constexpr double most_shrinking = -0.2;
constexpr double most_growing = 0.25;
// Conjugate gradients for the multipliers: what is left of an error is dealt with in the next step.
constexpr double solved = 1e-3;

double dot(std::span<const double> a, std::span<const double> b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

// The fields L^-1 G^T lambda, with L the Laplacian of the film and G the volume gradients.
class Stretching {
 public:
  Stretching(const scene::Scene& scene, Problem& problem)
      : problem_(problem), metric_(film_metric(scene, problem)), moved_(problem.vertex_count()) {
    for (std::size_t v = 0; v < moved_.size(); ++v) moved_[v] = problem.movable(v) ? 1 : 0;
  }

  bool factorise(std::span<const Vec3> x) { return metric_->factorise(x); }

  // The field that changes volumes by `change`; false if there is none.
  bool find(std::span<const double> change, std::span<Vec3> field) {
    std::vector<double> lambda(change.size());
    std::vector<double> residual(change.begin(), change.end());
    std::vector<double> way = residual;
    std::vector<double> image(change.size());
    double length = dot(residual, residual);
    const double enough = solved * solved * length;
    for (std::size_t round = 0; length > enough && round < 2 * change.size() + 2; ++round) {
      respond(way, field);
      problem_.energy().volume_gradient().dot(moved_, field, image);
      const double curvature = dot(way, image);
      if (!(curvature > 0)) return false;
      const double step = length / curvature;
      for (std::size_t i = 0; i < way.size(); ++i) {
        lambda[i] += step * way[i];
        residual[i] -= step * image[i];
      }
      const double before = length;
      length = dot(residual, residual);
      for (std::size_t i = 0; i < way.size(); ++i) way[i] = residual[i] + length / before * way[i];
    }
    respond(lambda, field);
    return true;
  }

 private:
  void respond(std::span<const double> lambda, std::span<Vec3> field) {
    energy::VolumeGradient& gradient = problem_.energy().volume_gradient();
    gradient.set_multipliers(lambda);
    for (std::size_t v = 0; v < field.size(); ++v) field[v] = moved_[v] * gradient.pull(v);
    metric_->solve(field);
  }

  Problem& problem_;
  std::unique_ptr<Metric> metric_;
  std::vector<double> moved_;
};

}  // namespace

Ending reach_volumes(const scene::Scene& scene, Problem& problem, std::span<Vec3> x, double& energy) {
  if (!problem.constrain(x)) return Ending::constraint_lost;
  bool ok = false;
  energy = problem.linearise(x, ok);
  if (!ok || problem.volume_error() < small_error) return problem.restore_volumes(x, energy);
  Stretching stretching(scene, problem);
  std::vector<Vec3> field(x.size());
  std::vector<double> change(problem.constraint_count());
  for (int step = 0; step < most_steps && problem.volume_error() >= small_error; ++step) {
    if (!stretching.factorise(x)) break;
    for (std::size_t i = 0; i < change.size(); ++i) {
      const double held = problem.energy().held_values()[i];
      change[i] = problem.targets()[i] - held;
      if (i >= problem.energy().constrained().size()) continue;
      const double size = std::max(std::abs(held), 0.01 * std::abs(problem.targets()[i]));
      change[i] = std::clamp(change[i], most_shrinking * size, most_growing * size);
    }
    if (!stretching.find(change, field)) break;
    for (std::size_t v = 0; v < x.size(); ++v) x[v] += field[v];
    if (!problem.constrain(x)) return Ending::constraint_lost;
    energy = problem.linearise(x, ok);
    if (!ok) return std::isfinite(energy) ? Ending::volume_lost : Ending::not_finite;
  }
  return problem.restore_volumes(x, energy);
}

}  // namespace lamella::solve
