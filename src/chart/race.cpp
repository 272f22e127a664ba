#include "chart/race.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <map>

#include "evolution/adapt.h"
#include "evolution/minimisers.h"

namespace lamella::chart {

namespace {

using evolution::Minimiser;

constexpr long most_iterations = 100000;
constexpr double tolerance = 1e-10;
// A sample is worth keeping if so much more time has passed.
constexpr double growth = 1.03;

double processor_time() {
  timespec now{};
  ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

// Notes the energy as a method goes on, and stops it at the limit.
class Recorder : public scene::Monitor {
 public:
  Recorder(const scene::Scene& scene, double limit, scene::Monitor& above)
      : scene_(scene), limit_(limit), above_(above), start_(processor_time()) {}

  bool stop_requested() override { return above_.stop_requested() || seconds() > limit_; }
  void progress(long done, long total, double energy) override {
    above_.progress(done, total, energy);
    const double now = seconds();
    if (samples_.empty() || now > growth * samples_.back().seconds) note(now, energy);
  }
  void note(double energy) { note(seconds(), energy); }
  std::vector<Sample> take() { return std::move(samples_); }

 private:
  double seconds() const { return processor_time() - start_; }
  void note(double seconds, double energy) {
    if (std::isfinite(energy)) samples_.push_back({seconds, scene_.film.triangle_count(), energy});
  }

  const scene::Scene& scene_;
  double limit_;
  scene::Monitor& above_;
  double start_;
  std::vector<Sample> samples_;
};

void climb(Minimiser method, scene::Scene& scene, const RaceOptions& options, Recorder& recorder) {
  evolution::RelaxOptions wanted;
  wanted.most_iterations = most_iterations;
  wanted.tolerance = tolerance;
  for (long level = 0; level <= options.levels && !recorder.stop_requested(); ++level) {
    if (level > 0) evolution::refine_everywhere(scene);
    recorder.note(evolution::relax_by(method, scene, wanted, recorder).energy);
  }
}

}  // namespace

const std::vector<std::string>& own_methods() {
  static const std::vector<std::string> names{"relax", "adaptive", "lbfgs", "newton", "cg", "descent"};
  return names;
}

Curve run_own(const std::string& method, scene::Scene scene, const RaceOptions& options,
              scene::Monitor& monitor, std::optional<evolution::Extrapolation>* relaxed) {
  static const std::map<std::string, Minimiser> single{{"lbfgs", Minimiser::lbfgs},
                                                       {"newton", Minimiser::newton},
                                                       {"cg", Minimiser::conjugate},
                                                       {"descent", Minimiser::descent}};
  Recorder recorder(scene, options.limit, monitor);
  if (const auto at = single.find(method); at != single.end()) {
    climb(at->second, scene, options, recorder);
  } else {
    const double most = scene.film.triangle_count() * std::pow(4.0, static_cast<double>(options.levels));
    const evolution::LevelsReport report = method == "adaptive"
                                               ? evolution::relax_to(scene, 1e-12, most, {}, recorder)
                                               : evolution::relax_levels(scene, options.levels, {}, recorder);
    recorder.note(report.relax.energy);
    if (relaxed != nullptr) *relaxed = report.extrapolation;
  }
  return {method, recorder.take()};
}

}  // namespace lamella::chart
