// The inner product in which a descent measures steps.
#pragma once

#include <span>

#include "film/vec3.h"

namespace lamella::solve {

class Metric {
 public:
  virtual ~Metric() = default;
  // Assembles and factorises at x. False if that fails.
  virtual bool factorise(std::span<const film::Vec3> x) = 0;
  // Turns a force (a row a vertex) into the step that it wants: the inverse of the metric applied to it.
  virtual void solve(std::span<film::Vec3> field) = 0;
};

}  // namespace lamella::solve
