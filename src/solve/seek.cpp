#include "solve/seek.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace lamella::solve {

namespace {

constexpr double least_part = 1e-6;  // of the first trial
constexpr int most_doublings = 60;
constexpr int most_refinements = 3;

// The energy along the line; what cannot be reached counts as infinitely high.
class Line {
 public:
  Line(Problem& problem, std::span<Vec3> x, std::span<const Vec3> way)
      : problem_(problem), x_(x), way_(way), from_(x.begin(), x.end()) {}

  double operator()(double t) {
    for (std::size_t v = 0; v < x_.size(); ++v) x_[v] = from_[v] + t * way_[v];
    double energy = 0;
    const Ending ending = problem_.restore_volumes(x_, energy, RestoreMode::same_gradients);
    return ending == Ending::converged && std::isfinite(energy) ? energy : HUGE_VAL;
  }
  void back() { std::copy(from_.begin(), from_.end(), x_.begin()); }

 private:
  Problem& problem_;
  std::span<Vec3> x_;
  std::span<const Vec3> way_;
  std::vector<Vec3> from_;
};

struct Point {
  double at = 0;
  double energy = 0;
};

// The minimum of the parabola through three points, the middle one lowest.
double vertex_of_parabola(const Point& a, const Point& b, const Point& c) {
  const double p = (b.at - a.at) * (b.energy - c.energy);
  const double q = (b.at - c.at) * (b.energy - a.energy);
  return p == q ? b.at : b.at - 0.5 * ((b.at - a.at) * p - (b.at - c.at) * q) / (p - q);
}

}  // namespace

SeekResult seek_lowest(Problem& problem, std::span<Vec3> x, std::span<const Vec3> way, double first,
                       double longest) {
  Line line(problem, x, way);
  const double start = problem.energy().value(x);
  double t = first;
  Point low;
  while (t > least_part * first) {
    const Point ahead{t, line(t)};
    const Point behind{-t, line(-t)};
    low = ahead.energy <= behind.energy ? ahead : behind;
    if (low.energy < start) break;
    t /= 2;
  }
  if (!(low.energy < start)) {
    line.back();
    return {false, start, 0};
  }
  Point before{0, start};
  Point after{2 * low.at, HUGE_VAL};
  for (int i = 0; i < most_doublings && std::abs(low.at) < longest; ++i) {
    after.at = std::clamp(2 * low.at, -longest, longest);
    after.energy = line(after.at);
    if (!(after.energy < low.energy)) break;
    before = low;
    low = after;
  }
  for (int i = 0; i < most_refinements && std::isfinite(after.energy) && after.at != low.at; ++i) {
    const Point next{vertex_of_parabola(before, low, after), 0};
    if (std::abs(next.at - low.at) < 1e-2 * std::abs(low.at)) break;
    const Point tried{next.at, line(next.at)};
    const bool beyond = std::abs(tried.at) > std::abs(low.at);
    if (tried.energy < low.energy) {
      (beyond ? before : after) = low;
      low = tried;
    } else {
      (beyond ? after : before) = tried;
    }
  }
  return {true, line(low.at), low.at};
}

}  // namespace lamella::solve
