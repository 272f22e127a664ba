#include "picture/view.h"

#include <algorithm>
#include <cmath>

namespace lamella::picture {

using film::Vec3;

Rotation operator*(const Rotation& a, const Rotation& b) {
  return {a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z, a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
          a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x, a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w};
}

Rotation about(const Vec3& axis, double angle) {
  const Vec3 v = std::sin(angle / 2) * unit(axis);
  return {std::cos(angle / 2), v.x, v.y, v.z};
}

Axes axes(const Rotation& q) {
  return {Vec3{1 - 2 * (q.y * q.y + q.z * q.z), 2 * (q.x * q.y - q.w * q.z), 2 * (q.x * q.z + q.w * q.y)},
          Vec3{2 * (q.x * q.y + q.w * q.z), 1 - 2 * (q.x * q.x + q.z * q.z), 2 * (q.y * q.z - q.w * q.x)},
          Vec3{2 * (q.x * q.z - q.w * q.y), 2 * (q.y * q.z + q.w * q.x), 1 - 2 * (q.x * q.x + q.y * q.y)}};
}

// First the scene is turned about z until the viewer's direction lies above -y, then about x until it
// points out of the picture.
Rotation looking_from(const Vec3& direction) {
  const Vec3 d = unit(direction);
  const double azimuth = std::hypot(d.x, d.y) > 1e-12 ? std::atan2(d.x, -d.y) : M_PI / 2;
  const double elevation = std::atan2(d.z, std::hypot(d.x, d.y));
  return about({1, 0, 0}, elevation - M_PI / 2) * about({0, 0, 1}, -azimuth);
}

namespace {

Vec3 direction(double azimuth_degrees, double elevation_degrees) {
  const double azimuth = azimuth_degrees * M_PI / 180;
  const double elevation = elevation_degrees * M_PI / 180;
  return {std::sin(azimuth) * std::cos(elevation), -std::cos(azimuth) * std::cos(elevation),
          std::sin(elevation)};
}

// How well the film is seen from a direction: the mean over its area of a measure that falls from 1 to 0
// where the angle of sight gets below 30 degrees. A few thousand facets tell as much as all.
double clearness(const film::Film& film, const Vec3& from) {
  const std::uint32_t stride = 1 + film.triangle_rows() / 4096;
  double clear = 0;
  double whole = 0;
  for (std::uint32_t t = 0; t < film.triangle_rows(); t += stride) {
    if (!film.alive(film::Triangle(t))) continue;
    const auto& c = film.corners(film::Triangle(t));
    const Vec3 a = film.position(c[0]);
    const Vec3 normal = cross(film.position(c[1]) - a, film.position(c[2]) - a);
    const double area = length(normal);
    clear += std::min(2 * std::abs(dot(normal, from)), area);
    whole += area;
  }
  return whole > 0 ? clear / whole : 1;
}

}  // namespace

View view_of(const scene::Scene& scene) {
  View view;
  if (scene.strings.on && scene.strings.dimension == 2) {
    view.field_of_view = 0;
    return view;
  }
  // Earlier ones are preferred unless a later one is clearly better.
  constexpr double azimuths_elevations[][2] = {{26, 22}, {62, 24}, {-62, 26}, {22, 34}, {14, 28}};
  constexpr double clearly = 0.045;
  Vec3 best;
  double best_clearness = -1;
  for (const auto& [azimuth, elevation] : azimuths_elevations) {
    const Vec3 from = direction(azimuth, elevation);
    const double clear = clearness(scene.film, from);
    if (clear < best_clearness + clearly) continue;
    best = from;
    best_clearness = clear;
  }
  view.rotation = looking_from(best);
  return view;
}

}  // namespace lamella::picture
