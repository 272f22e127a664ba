// From where a scene is looked at.
#pragma once

#include <array>

#include "film/vec3.h"
#include "scene/scene.h"

namespace lamella::picture {

// A rotation as a unit quaternion.
struct Rotation {
  double w = 1;
  double x = 0;
  double y = 0;
  double z = 0;

  friend constexpr bool operator==(const Rotation&, const Rotation&) = default;
};

Rotation operator*(const Rotation& second, const Rotation& first);
Rotation about(const film::Vec3& axis, double angle);

// The directions in the scene that point right, up and towards the viewer.
using Axes = std::array<film::Vec3, 3>;
Axes axes(const Rotation& rotation);

// The rotation of a viewer who stands in this direction from the scene, with z upward in the picture (x,
// where that is the direction itself).
Rotation looking_from(const film::Vec3& direction);

// The whole scene fills the picture, less a margin, at zoom 1 without an offset.
struct View {
  Rotation rotation;  // takes scene directions to right, up, towards the viewer
  double zoom = 1;
  double right = 0;  // moves the scene, in heights of the picture
  double up = 0;
  double field_of_view = 26;  // degrees, of the whole scene; 0 for a parallel projection
};

// From slightly above and somewhat to the right of the -y axis; turned further where most of the film would
// be seen edge on. A film in the plane is seen from above, x to the right and y up.
View view_of(const scene::Scene& scene);

}  // namespace lamella::picture
