#include "solve/stability.h"

namespace lamella::solve {

namespace {

constexpr double neutral = 1e-3;  // in units of NewtonSystem::scale

}  // namespace

Stability stability(NewtonSystem& system) {
  Stability result;
  if (!system.factorise(0)) return result;
  const int negative = system.negative_modes();
  if (negative > 0) {
    if (!system.factorise(neutral * system.scale())) return result;
    result.negative_modes = system.negative_modes();
  }
  result.neutral_modes = negative - result.negative_modes;
  result.known = true;
  return result;
}

}  // namespace lamella::solve
