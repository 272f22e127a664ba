// The projection of a scene to a picture.
#pragma once

#include <span>

#include "picture/view.h"

namespace lamella::picture {

using Point = std::array<float, 3>;

// Projects a point p: v = (right, up, towards) . p is relative to `eye`; the picture's position is
// x = x_scale * v.x / -v.z + x_shift (parallel: x_scale * v.x + x_shift), in [-1, 1] from left to right, and
// likewise y from bottom to top. The depth is -v.z.
struct Camera {
  Axes axes;
  film::Vec3 eye;  // in the directions of the axes
  bool parallel = false;
  double x_scale = 1;
  double y_scale = 1;
  double x_shift = 0;
  double y_shift = 0;
  double nearest = 0;  // depths between which all points lie
  double farthest = 1;

  // x and y in [-1, 1], and the depth.
  film::Vec3 project(const film::Vec3& p) const;
};

// The part of the width or height that stays free on each side of the scene.
inline constexpr double margin = 0.06;

// The camera of a view with all points in the picture, the balls of `radius` around them included.
// `aspect` is width over height.
Camera fit_camera(std::span<const Point> points, double radius, const View& view, double aspect);

// Sets the depths between which these points lie; what is behind the eye is not drawn.
void set_depths(Camera& camera, std::span<const Point> points, double radius);

}  // namespace lamella::picture
