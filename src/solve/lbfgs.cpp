#include "solve/lbfgs.h"

#include <algorithm>
#include <cmath>
#include <deque>

#include "film/blocks.h"
#include "solve/film_metric.h"

namespace lamella::solve {

namespace {

constexpr std::size_t memory_length = 10;
constexpr int renewal = 20;
constexpr int most_trials = 20;
constexpr double armijo = 1e-4;

using Field = std::vector<Vec3>;

double product(const Field& a, const Field& b) {
  return film::sum_of_blocks(a.size(), [&](std::size_t first, std::size_t last) {
    double sum = 0;
    for (std::size_t i = first; i < last; ++i) sum += dot(a[i], b[i]);
    return sum;
  });
}

void add_scaled(Field& a, double factor, const Field& b) {
  film::for_each_block(a.size(), [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) a[i] += factor * b[i];
  });
}

// A step taken and what it did to the gradient.
struct Pair {
  Field step;
  Field change;
  double curvature = 0;  // step . change
};

class Minimiser {
 public:
  Minimiser(Problem& problem, const scene::Scene& scene, std::span<Vec3> x, MotionKind motion)
      : problem_(problem),
        metric_(film_metric(scene, problem)),
        freedom_(scene.film, motion),
        x_(x),
        from_(x.size()),
        force_(x.size()),
        last_force_(x.size()),
        direction_(x.size()) {}

  LbfgsReport run(const LbfgsOptions& options, scene::Monitor& monitor);

 private:
  Ending start();
  bool renew();
  void find_force();
  void find_direction();
  bool search(double& energy);
  void remember();

  Problem& problem_;
  std::unique_ptr<Metric> metric_;
  Freedom freedom_;
  std::span<Vec3> x_;
  Field from_;
  Field force_;  // minus the projected gradient at x
  Field last_force_;
  Field direction_;
  std::deque<Pair> memory_;
  double energy_ = 0;
  double slope_ = 0;
  int since_renewal_ = 0;
  // Forces are restricted to what changes the shape. The mesh at first follows them smoothly, as the
  // Laplacian spreads them, which keeps it even; where the energy of a curved mesh objects to the sliding, it
  // stops following.
  bool strict_ = false;
};

// At x with its volumes right: energy, force and a fresh metric. Anything but Ending::converged means that it
// cannot go on from here.
Ending Minimiser::start() {
  bool ok = false;
  energy_ = problem_.linearise(x_, ok);
  if (!ok) return std::isfinite(energy_) ? Ending::volume_lost : Ending::not_finite;
  memory_.clear();
  return renew() ? Ending::converged : Ending::stuck;
}

// A new metric and, as directions of motion change, a new force; what was learnt in other directions is of
// little use.
bool Minimiser::renew() {
  since_renewal_ = 0;
  freedom_.renew(x_);
  find_force();
  return metric_->factorise(x_);
}

void Minimiser::find_force() {
  problem_.descent_direction(force_);
  freedom_.restrict(force_);
}

// The two-loop recursion around the projected inverse Laplacian.
void Minimiser::find_direction() {
  direction_ = force_;
  std::vector<double> alpha(memory_.size());
  for (std::size_t i = memory_.size(); i-- > 0;) {
    alpha[i] = product(memory_[i].step, direction_) / memory_[i].curvature;
    add_scaled(direction_, -alpha[i], memory_[i].change);
  }
  problem_.project(direction_);
  metric_->solve(direction_);
  if (strict_) freedom_.restrict(direction_);
  problem_.project(direction_);
  for (std::size_t i = 0; i < memory_.size(); ++i) {
    const double beta = product(memory_[i].change, direction_) / memory_[i].curvature;
    add_scaled(direction_, alpha[i] - beta, memory_[i].step);
  }
  slope_ = -product(force_, direction_);
}

// Backtracks from the full step; leaves x and `energy` at the accepted point or where they were.
bool Minimiser::search(double& energy) {
  std::copy(x_.begin(), x_.end(), from_.begin());
  double t = 1;
  for (int trial = 0; trial < most_trials; ++trial) {
    for (std::size_t v = 0; v < x_.size(); ++v) x_[v] = from_[v] + t * direction_[v];
    const Ending restored = problem_.restore_volumes(x_, energy, RestoreMode::same_gradients);
    if (restored == Ending::converged && energy <= energy_ + armijo * t * slope_) return true;
    const double bend = restored == Ending::converged ? energy - energy_ - t * slope_ : HUGE_VAL;
    const double wanted = bend > 0 && std::isfinite(bend) ? -0.5 * slope_ * t * t / bend : 0;
    t = std::clamp(wanted, 0.1 * t, 0.5 * t);
  }
  std::copy(from_.begin(), from_.end(), x_.begin());
  return false;
}

void Minimiser::remember() {
  Pair pair;
  if (memory_.size() == memory_length) {
    pair = std::move(memory_.front());
    memory_.pop_front();
  }
  pair.step.resize(x_.size());
  pair.change.resize(x_.size());
  for (std::size_t v = 0; v < x_.size(); ++v) {
    pair.step[v] = x_[v] - from_[v];
    pair.change[v] = last_force_[v] - force_[v];
  }
  pair.curvature = product(pair.step, pair.change);
  // Only steps along which the gradient grows say something about a minimum.
  if (pair.curvature > 1e-12 * std::sqrt(product(pair.step, pair.step) * product(pair.change, pair.change))) {
    memory_.push_back(std::move(pair));
  }
}

LbfgsReport Minimiser::run(const LbfgsOptions& options, scene::Monitor& monitor) {
  LbfgsReport report;
  const auto end = [&](Ending ending) {
    report.ending = ending;
    report.energy = energy_;
    return report;
  };
  if (const Ending ready = start(); ready != Ending::converged) return end(ready);
  bool fresh = true;
  while (true) {
    find_direction();
    if (!std::isfinite(slope_)) return end(Ending::not_finite);
    report.residual = slope_ == 0 ? 0 : -0.5 * slope_ / std::abs(energy_);
    if (std::abs(report.residual) < options.tolerance) return end(Ending::converged);
    if (report.iterations == options.most_iterations) return end(Ending::step_limit);
    double energy = energy_;
    if (!(slope_ < 0) || !search(energy)) {
      if (fresh && strict_) return end(Ending::stuck);
      strict_ = fresh;
      if (const Ending ready = start(); ready != Ending::converged) return end(ready);
      fresh = true;
      continue;
    }
    fresh = false;
    std::swap(force_, last_force_);
    bool ok = false;
    energy_ = problem_.linearise(x_, ok);
    if (!ok) return end(Ending::volume_lost);
    find_force();
    remember();
    ++report.iterations;
    if (++since_renewal_ >= renewal && !renew()) return end(Ending::stuck);
    monitor.progress(report.iterations, options.most_iterations, energy_);
    if (monitor.stop_requested()) return end(Ending::stopped);
  }
}

}  // namespace

LbfgsReport lbfgs(Problem& problem, const scene::Scene& scene, std::span<Vec3> x, const LbfgsOptions& options,
                  scene::Monitor& monitor) {
  return Minimiser(problem, scene, x, options.motion).run(options, monitor);
}

}  // namespace lamella::solve
