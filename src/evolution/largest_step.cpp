#include "evolution/largest_step.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "evolution/masses.h"

namespace lamella::evolution {

namespace {

constexpr double start_speed = 1e-7;
// Energy above the start is a failure beyond this part of a facet's, and what the film has given off since:
// so much may pass into the shortest waves, whose energy swings by as much as they have where steps are long.
constexpr double most_rise = 0.01;
// The gradient flow does nothing but give energy off: what it may gain in a step is rounding.
constexpr double most_gradient_rise = 1e-6;
constexpr double most_volume_error = 1e-4;
constexpr double crowded = 3;
constexpr double implicit_accuracy = 0.1;

// The gradient flow has no velocities: places instead, by as much over the time 1.
void stir(scene::Scene& scene, Method method) {
  std::mt19937_64 numbers(1);
  std::normal_distribution<double> any(0, start_speed);
  if (method == Method::gradient) {
    const auto fixed = scene.film.columns(film::ElementKind::vertex).flags("fixed");
    const std::span<Vec3> places = scene.film.edit_positions();
    for (std::size_t v = 0; v < places.size(); ++v) {
      const Vec3 move{any(numbers), any(numbers), any(numbers)};
      if (fixed.empty() || fixed[v] == 0) places[v] += move;
    }
    return;
  }
  std::vector<Vec3> velocity = velocities(scene.film);
  for (Vec3& v : velocity) {
    for (int axis = 0; axis < 3; ++axis) v[axis] += any(numbers);
  }
  store_velocities(scene.film, velocity);
}

// What becomes of the film at so large a part of the bound; empty if it survives.
std::string failure_at(scene::Scene scene, Method method, double fraction, const Trials& trials) {
  stir(scene, method);
  Motion motion(scene, method, VolumeMode::exact);
  const double end = scene.time + trials.steps * motion.bound();
  const double start = motion.energy() + motion.kinetic() - scene.work;
  const double facet = std::abs(motion.energy()) / static_cast<double>(scene.film.triangle_count());
  double least = motion.energy() - scene.work;
  const double fewest = is_implicit(method) ? trials.implicit_steps : 0;
  // A mesh that shrinks would let the time pass ever more slowly.
  const double most = std::max(fewest, crowded * trials.steps / fraction);
  for (double made = 0; (scene.time < end && made < most) || made < fewest; ++made) {
    const double before = motion.energy();
    const solve::Ending ending = motion.step(fraction * motion.bound());
    if (ending == solve::Ending::stuck) return "energy from nowhere";
    if (ending != solve::Ending::step_limit) return std::string(solve::describe(ending));
    const double rise = motion.energy() + motion.kinetic() - scene.work - start;
    least = std::min(least, motion.energy() - scene.work);
    if (!(rise < most_rise * facet + (start - least))) return "energy grows";
    if (method == Method::gradient && motion.energy() > before + most_gradient_rise * facet)
      return "energy grows";
    if (!(motion.volume_error() < most_volume_error)) return "volumes drift";
  }
  return {};
}

}  // namespace

LargestStep find_largest_step(const scene::Scene& scene, Method method, const Trials& trials,
                              scene::Monitor& monitor) {
  LargestStep result;
  {
    scene::Scene copy = scene;
    result.bound = Motion(copy, is_implicit(method) ? Method::euler : method).bound();
  }
  if (!std::isfinite(result.bound)) return result;
  const double accuracy = is_implicit(method) ? implicit_accuracy : trials.accuracy;
  double low = 0;
  double high = 0.5;
  while (high <= trials.longest && !monitor.stop_requested()) {
    result.failure = failure_at(scene, method, high, trials);
    if (!result.failure.empty()) break;
    low = high;
    high *= 2;
  }
  result.limited = !result.failure.empty();
  result.fraction = low;
  if (!result.limited) return result;
  while (high - low > accuracy * high && !monitor.stop_requested()) {
    const double middle = low > 0 ? std::sqrt(low * high) : 0.5 * high;
    const std::string failure = failure_at(scene, method, middle, trials);
    (failure.empty() ? low : high) = middle;
    if (!failure.empty()) result.failure = failure;
  }
  result.fraction = low;
  return result;
}

}  // namespace lamella::evolution
