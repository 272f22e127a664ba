// A soft shadow on the ground under a scene.
#pragma once

#include <vector>

#include "picture/camera.h"
#include "picture/drawing.h"

namespace lamella::picture {

// The ground lies a little below the lowest point, square to z. Light falls on it from straight above and,
// the farther it is from what throws the shadow, from ever more directions, so that edges are soft. Films let
// most of the light through, tubes none.
class GroundShadow {
 public:
  // No shadow at all.
  GroundShadow() = default;
  explicit GroundShadow(const Drawing& drawing);

  bool empty() const { return shade_.empty(); }
  // What is left of the light on the ground behind a pixel, 0 to 1; x and y in [-1, 1] as the camera's. 1
  // where the camera sees no ground.
  float light(const Camera& camera, double x, double y) const;

 private:
  static constexpr int cells = 192;  // in each direction
  double at(double x, double y) const;

  double ground_ = 0;
  double left_ = 0;  // of the square that is kept
  double front_ = 0;
  double cell_ = 0;  // size of one; 0 for no shadow
  std::vector<float> shade_;
};

// A shadow as a camera sees it.
struct CastShadow {
  const GroundShadow& ground;
  const Camera& camera;

  // Of a picture with so many pixels, counted from the upper left.
  float light(int x, int y, int width, int height) const {
    if (ground.empty()) return 1;
    return ground.light(camera, (2 * x + 1.0) / width - 1, 1 - (2 * y + 1.0) / height);
  }
};

}  // namespace lamella::picture
