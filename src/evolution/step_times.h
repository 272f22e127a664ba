// Where the time of a moving film's steps goes.
#pragma once

#include <chrono>

namespace lamella::evolution {

// Seconds of wall time, summed over steps.
struct StepTimes {
  double forces =
      0;  // energy, gradients and what goes along with their sweep, outer forces, implicit systems
  double volumes = 0;  // volume constraints: their systems, corrections, looks at volumes
  double surgery = 0;  // the mesh kept fit, topology
  double other = 0;    // kicks and moves by themselves, bookkeeping
  long steps = 0;      // parts counted
  double facets = 0;   // summed over the steps

  double sum() const { return forces + volumes + surgery + other; }
};

// Splits time between the parts: each lap lasts until the next begins.
class Stopwatch {
 public:
  void start() { last_ = Clock::now(); }
  void lap(double& part) {
    const Clock::time_point now = Clock::now();
    part += std::chrono::duration<double>(now - last_).count();
    last_ = now;
  }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point last_ = Clock::now();
};

}  // namespace lamella::evolution
