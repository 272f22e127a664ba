// How long steps may be before a moving film comes apart, found by trial.
#pragma once

#include <string>

#include "evolution/motion.h"
#include "scene/monitor.h"

namespace lamella::evolution {

struct LargestStep {
  double bound = 0;     // the predicted one, at the start; that of symplectic Euler for implicit methods
  double fraction = 0;  // of the bound, as it is at each step: the largest that survives
  bool limited = true;  // false if even the longest step tried survives
  std::string failure;  // what became of the film a little above
};

struct Trials {
  double steps = 300;          // of the predicted bound: the time that a film has to survive
  double accuracy = 0.01;      // of the result
  double longest = 400;        // of the bound
  double implicit_steps = 20;  // at least so many of an implicit method, however long
};

// Bisects. A trial starts with a random velocity far below what is seen (a ten-millionth of the speed of
// waves), on a fixed mesh, with volumes exact. It fails if a step cannot be made, if energy rises above start
// plus work by more than a hundredth of a facet's and what the film has given off (in the gradient flow: if
// it rises at all), or if a volume is off by more than a ten-thousandth.
LargestStep find_largest_step(const scene::Scene& scene, Method method, const Trials& trials,
                              scene::Monitor& monitor);

}  // namespace lamella::evolution
