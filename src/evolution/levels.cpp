#include "evolution/levels.h"

#include <algorithm>
#include <cmath>

#include "evolution/adapt.h"

namespace lamella::evolution {

namespace {

// Levels on the way need no more than what the next one changes.
constexpr double coarse_tolerance = 1e-8;
// Errors fall by no less than this, whatever an odd pair of levels says.
constexpr double slowest = 0.9;
// What may be wrong in the sum of the facets' own estimates.
constexpr double doubt = 0.1;
constexpr double nearly_four = 3.8;
// Levels that agree to this are the same film.
constexpr double rounding = 1e-13;

// Relaxes level after level and keeps account of them.
class Ladder {
 public:
  Ladder(scene::Scene& scene, const RelaxOptions& options, scene::Monitor& monitor)
      : scene_(scene), options_(options), monitor_(monitor) {}

  // False where it ended in a way that leaves no point in going on.
  bool relax_level(double tolerance) {
    RelaxOptions options = options_;
    options.near_start = !report_.levels.empty();
    options.tolerance = std::max(tolerance, options.tolerance);
    const RelaxReport before = report_.relax;
    report_.relax = relax(scene_, options, monitor_);
    report_.relax.iterations += before.iterations;
    report_.relax.newton_steps += before.newton_steps;
    report_.relax.flips += before.flips;
    report_.relax.new_meshes += before.new_meshes;
    report_.levels.push_back({scene_.film.triangle_count(), report_.relax.energy});
    return report_.relax.converged();
  }
  void finish() {
    report_.levels.pop_back();
    relax_level(0);
  }
  LevelsReport& report() { return report_; }

 private:
  scene::Scene& scene_;
  RelaxOptions options_;
  scene::Monitor& monitor_;
  LevelsReport report_;
};

}  // namespace

std::optional<Extrapolation> extrapolate(const std::vector<Level>& levels) {
  if (levels.size() < 3) return std::nullopt;
  const Level& last = levels.back();
  const Level& before = levels[levels.size() - 2];
  const Level& first = levels[levels.size() - 3];
  const double change = last.energy - before.energy;
  const double earlier = before.energy - first.energy;
  Extrapolation result;
  result.energy = last.energy;
  if (std::abs(change) <= rounding * std::abs(last.energy)) return result;
  // With errors c / facets, the one left is `part` times the last change.
  const double expected = static_cast<double>(before.facets) / last.facets;
  const double growth = std::log(static_cast<double>(last.facets) / first.facets) / 2;
  const double seen = std::abs(change) / std::max(std::abs(earlier), 1e-300);
  if (change * earlier > 0 && seen < 1) result.order = -std::log(seen) / growth;
  const double ratio = std::clamp(change * earlier > 0 ? std::max(expected, seen) : expected, 0.0, slowest);
  const double left = change * ratio / (1 - ratio);
  result.energy = last.energy + left;
  result.estimate = std::abs(left / result.energy);
  return result;
}

LevelsReport relax_levels(scene::Scene& scene, long levels, const RelaxOptions& options,
                          scene::Monitor& monitor) {
  Ladder ladder(scene, options, monitor);
  for (long level = 0; level < levels; ++level) {
    if (!ladder.relax_level(coarse_tolerance)) return ladder.report();
    refine_smoothly(scene);
  }
  ladder.relax_level(0);
  ladder.report().extrapolation = extrapolate(ladder.report().levels);
  return ladder.report();
}

namespace {

// True if the last levels are refined everywhere, or nearly.
bool regular(const std::vector<Level>& levels) {
  const std::size_t n = levels.size();
  return levels[n - 1].facets > nearly_four * levels[n - 2].facets &&
         levels[n - 2].facets > nearly_four * levels[n - 3].facets;
}

// Levels that were refined in part do not follow a rule, and what the mesh itself tells stands in for them.
// Curves and corners that it does not resolve hide from that, so the estimate is the worse one.
void mend(Extrapolation& extrapolation, const scene::Scene& scene, const std::vector<Level>& levels) {
  const ErrorSums errors = sum_errors(facet_errors(scene));
  const double last = levels.back().energy;
  if (!regular(levels)) extrapolation.energy = last - errors.whole;
  extrapolation.estimate =
      std::max(extrapolation.estimate, (std::abs(errors.whole) + doubt * errors.sizes) / std::abs(last));
}

}  // namespace

LevelsReport relax_to(scene::Scene& scene, double accuracy, double most_facets, const RelaxOptions& options,
                      scene::Monitor& monitor) {
  Ladder ladder(scene, options, monitor);
  LevelsReport& report = ladder.report();
  const double tolerance = std::min(coarse_tolerance, 0.01 * accuracy);
  while (ladder.relax_level(tolerance)) {
    report.extrapolation = extrapolate(report.levels);
    if (report.extrapolation) mend(*report.extrapolation, scene, report.levels);
    report.accurate = report.extrapolation && report.extrapolation->estimate < accuracy;
    if (report.accurate) break;
    // No level makes more than four facets of one.
    if (4.0 * scene.film.triangle_count() > most_facets) break;
    refine_where_needed(scene);
  }
  if (report.relax.converged()) ladder.finish();
  return report;
}

}  // namespace lamella::evolution
