// Finite differences, for tests of gradients.
#pragma once

#include <functional>
#include <vector>

#include "film/vec3.h"

namespace lamella::test {

// Central differences of fourth order of a function of positions.
inline std::vector<film::Vec3> gradient_by_differences(
    std::vector<film::Vec3> x, const std::function<double(const std::vector<film::Vec3>&)>& f,
    double h = 1e-3) {
  std::vector<film::Vec3> g(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      const double at = x[i][axis];
      const auto value = [&](double step) {
        x[i][axis] = at + step * h;
        const double result = f(x);
        x[i][axis] = at;
        return result;
      };
      g[i][axis] = (8 * (value(1) - value(-1)) - (value(2) - value(-2))) / (12 * h);
    }
  }
  return g;
}

}  // namespace lamella::test
