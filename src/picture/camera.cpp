#include "picture/camera.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lamella::picture {

using film::Vec3;

Vec3 Camera::project(const Vec3& p) const {
  const Vec3 v = Vec3{dot(axes[0], p), dot(axes[1], p), dot(axes[2], p)} - eye;
  const double w = parallel ? 1 : -v.z;
  return {x_scale * v.x / w + x_shift, y_scale * v.y / w + y_shift, -v.z};
}

namespace {

struct Range {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  void include(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  double centre() const { return (low + high) / 2; }
  double half() const { return (high - low) / 2; }
};

// A point at height z above the picture's plane is seen at the angle whose tangent is (x - eye.x) / (eye.z -
// z). That it be at most `slope` is linear in x + slope z and x - slope z, so the nearest eye follows from
// the extremes of these two: no iteration.
struct Cone {
  double slope = 1;
  double right = -std::numeric_limits<double>::infinity();  // largest x + slope z
  double left = -std::numeric_limits<double>::infinity();   // largest -x + slope z

  void include(double x, double z, double radius) {
    const double reach = radius * std::sqrt(1 + slope * slope);
    right = std::max(right, x + slope * z + reach);
    left = std::max(left, -x + slope * z + reach);
  }
  double centre() const { return (right - left) / 2; }
  double distance() const { return (right + left) / (2 * slope); }
};

Vec3 turned(const Axes& axes, const Point& point) {
  const Vec3 p{point[0], point[1], point[2]};
  return {dot(axes[0], p), dot(axes[1], p), dot(axes[2], p)};
}

void fit_parallel(Camera& camera, std::span<const Point> points, double radius, double aspect) {
  Range x;
  Range y;
  Range z;
  for (const Point& point : points) {
    const Vec3 p = turned(camera.axes, point);
    x.include(p.x);
    y.include(p.y);
    z.include(p.z);
  }
  camera.parallel = true;
  camera.eye = {x.centre(), y.centre(), z.high + radius + 1};
  camera.y_scale = (1 - 2 * margin) / std::max(y.half() + radius, (x.half() + radius) / aspect);
  camera.x_scale = camera.y_scale / aspect;
  camera.nearest = 1;
  camera.farthest = 1 + 2 * (z.half() + radius);
}

void fit_perspective(Camera& camera, std::span<const Point> points, double radius, double aspect,
                     double tangent) {
  // The field of view is that of the shorter side.
  const double height = tangent / std::min(1.0, aspect);
  Cone x{height * aspect * (1 - 2 * margin)};
  Cone y{height * (1 - 2 * margin)};
  Range z;
  for (const Point& point : points) {
    const Vec3 p = turned(camera.axes, point);
    x.include(p.x, p.z, radius);
    y.include(p.y, p.z, radius);
    z.include(p.z);
  }
  camera.eye = {x.centre(), y.centre(), std::max(x.distance(), y.distance())};
  camera.y_scale = 1 / height;
  camera.x_scale = camera.y_scale / aspect;
  camera.nearest = camera.eye.z - z.high - radius;
  camera.farthest = camera.eye.z - z.low + radius;
}

}  // namespace

Camera fit_camera(std::span<const Point> points, double radius, const View& view, double aspect) {
  Camera camera;
  camera.axes = axes(view.rotation);
  if (view.field_of_view > 0) {
    fit_perspective(camera, points, radius, aspect, std::tan(view.field_of_view * M_PI / 360));
  } else {
    fit_parallel(camera, points, radius, aspect);
  }
  camera.x_scale *= view.zoom;
  camera.y_scale *= view.zoom;
  camera.x_shift = 2 * view.right / aspect;
  camera.y_shift = 2 * view.up;
  return camera;
}

void set_depths(Camera& camera, std::span<const Point> points, double radius) {
  constexpr double nearest = 1e-3;
  Range depth;
  for (const Point& point : points) depth.include(camera.eye.z - turned(camera.axes, point).z);
  camera.nearest = std::max(depth.low - radius, nearest);
  camera.farthest = std::max(depth.high + radius, 2 * nearest);
}

}  // namespace lamella::picture
