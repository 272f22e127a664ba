#include "surgery/trial.h"

#include <algorithm>
#include <cmath>

namespace lamella::surgery {

using film::Vec3;

namespace {

constexpr double settled_part = 1e-7;  // of the energy: a step that wins less is the last

const Vec3& corner(const TrialFilm& film, const TrialFacet& facet, std::size_t k) {
  return film.points[static_cast<std::size_t>(facet.corners[k % 3])];
}

// The gradient at the free points, and a stiffness of each: the sum of opposite sides over altitudes.
void slope(const TrialFilm& film, std::vector<Vec3>& gradient, std::vector<double>& stiffness) {
  std::fill(gradient.begin(), gradient.end(), Vec3{});
  std::fill(stiffness.begin(), stiffness.end(), 0.0);
  for (const TrialFacet& facet : film.facets) {
    const Vec3 n = cross(corner(film, facet, 1) - corner(film, facet, 0),
                         corner(film, facet, 2) - corner(film, facet, 0));
    const double twice = length(n);
    for (std::size_t k = 0; k < 3; ++k) {
      const int v = facet.corners[k];
      if (v >= film.free) continue;
      const Vec3& next = corner(film, facet, k + 1);
      const Vec3& last = corner(film, facet, k + 2);
      const Vec3 side = last - next;
      const auto row = static_cast<std::size_t>(v);
      const double base = length(side);
      if (twice > 1e-14 * base * base) gradient[row] += (0.5 * facet.tension / twice) * cross(n, side);
      gradient[row] -= (facet.pressure / 6) * cross(next, last);
      stiffness[row] += 0.5 * facet.tension * squared_length(side) / std::max(twice, 0.05 * base * base);
    }
  }
}

}  // namespace

double energy(const TrialFilm& film) {
  double sum = 0;
  for (const TrialFacet& facet : film.facets) {
    const Vec3& a = corner(film, facet, 0);
    const Vec3& b = corner(film, facet, 1);
    const Vec3& c = corner(film, facet, 2);
    sum += 0.5 * facet.tension * length(cross(b - a, c - a)) - facet.pressure * dot(a, cross(b, c)) / 6;
  }
  return sum;
}

double relax(TrialFilm& film, const Vec3& centre, double radius, int most_steps) {
  const auto free = static_cast<std::size_t>(film.free);
  std::vector<Vec3> gradient(free);
  std::vector<double> stiffness(free);
  double best = energy(film);
  double scale = 1;
  for (int step = 0; step < most_steps && scale > 1e-3; ++step) {
    slope(film, gradient, stiffness);
    const std::vector<Vec3> start(film.points.begin(), film.points.begin() + film.free);
    for (std::size_t v = 0; v < free; ++v) {
      if (stiffness[v] <= 0) continue;
      Vec3 to = start[v] - (scale / stiffness[v]) * gradient[v] - centre;
      const double far = length(to);
      if (far > radius) to = (radius / far) * to;
      film.points[v] = centre + to;
    }
    const double now = energy(film);
    if (now < best) {
      const bool settled = best - now < settled_part * std::abs(best);
      best = now;
      scale = std::min(1.5, 1.3 * scale);
      if (settled) break;
    } else {
      std::copy(start.begin(), start.end(), film.points.begin());
      scale *= 0.4;
    }
  }
  return best;
}

double smallest_altitude(const TrialFilm& film) {
  double least = HUGE_VAL;
  for (const TrialFacet& facet : film.facets) {
    const Vec3& a = corner(film, facet, 0);
    const Vec3& b = corner(film, facet, 1);
    const Vec3& c = corner(film, facet, 2);
    const double longest =
        std::sqrt(std::max({squared_length(b - a), squared_length(c - b), squared_length(a - c)}));
    least = std::min(least, longest > 0 ? length(cross(b - a, c - a)) / longest : 0.0);
  }
  return least;
}

}  // namespace lamella::surgery
