#include "solve/parameter_border.h"

#include <cmath>

namespace lamella::solve {

namespace {

// The Lagrangian with other values of the parameters.
class Neighbourhood {
 public:
  Neighbourhood(Problem& problem, std::span<const Vec3> x)
      : problem_(problem),
        x_(x),
        here_(problem.parameters().values().begin(), problem.parameters().values().end()),
        moved_(x.size()) {}

  // Puts parameters and vertices there.
  void go(std::size_t k, double by_k, std::size_t l, double by_l) {
    std::vector<double> values = here_;
    values[k] += by_k * problem_.parameters().delta(k);
    values[l] += by_l * problem_.parameters().delta(l);
    problem_.set_parameters(values);
    std::copy(x_.begin(), x_.end(), moved_.begin());
    ok_ = problem_.constrain(moved_) && ok_;
  }
  double lagrangian(std::size_t k, double by_k, std::size_t l, double by_l) {
    go(k, by_k, l, by_l);
    return problem_.merit(moved_);
  }
  // Minus its gradient by the vertices, within their constraints there.
  void force(std::size_t k, double by, std::span<Vec3> field) {
    go(k, by, k, 0);
    ok_ = problem_.force_at(moved_, field) && ok_;
  }
  bool back() {
    problem_.set_parameters(here_);
    std::copy(x_.begin(), x_.end(), moved_.begin());
    return problem_.constrain(moved_) && ok_;
  }

 private:
  Problem& problem_;
  std::span<const Vec3> x_;
  std::vector<double> here_;
  std::vector<Vec3> moved_;
  bool ok_ = true;
};

}  // namespace

ParameterBorder parameter_border(Problem& problem, const Basis& basis, std::span<const Vec3> x, bool& ok) {
  ParameterBorder border;
  const FreeParameters& parameters = problem.parameters();
  const std::size_t count = parameters.size();
  const std::size_t held = problem.constraint_count();
  Neighbourhood near(problem, x);
  std::vector<Vec3> ahead(x.size());
  std::vector<Vec3> behind(x.size());
  border.square.resize(count * count);
  for (std::size_t k = 0; k < count; ++k) {
    const double delta = parameters.delta(k);
    near.force(k, 1, ahead);
    near.force(k, -1, behind);
    for (std::size_t v = 0; v < ahead.size(); ++v) ahead[v] = (behind[v] - ahead[v]) / (2 * delta);
    std::vector<double>& column = border.columns.emplace_back(basis.size() + held);
    basis.reduce(ahead, {column.data(), basis.size()});
    double force = -parameters.slope(k);
    for (std::size_t i = 0; i < held; ++i) {
      column[basis.size() + i] = parameters.held_slope(k, i);
      force += problem.pressures()[i] * parameters.held_slope(k, i);
    }
    border.force.push_back(force);
    for (std::size_t l = 0; l <= k; ++l) {
      // For k = l the outer two are two steps away.
      const double bend = near.lagrangian(k, 1, l, 1) - near.lagrangian(k, 1, l, -1) -
                          near.lagrangian(k, -1, l, 1) + near.lagrangian(k, -1, l, -1);
      border.square[k * count + l] = border.square[l * count + k] = bend / (4 * delta * parameters.delta(l));
    }
  }
  ok = near.back();
  if (ok) problem.linearise(x, ok);
  return border;
}

}  // namespace lamella::solve
