// A drawing as light: films, tubes and balls, tile by tile, to an image.
#pragma once

#include "picture/camera.h"
#include "picture/drawing.h"
#include "picture/image.h"
#include "picture/style.h"

namespace lamella::picture {

// With a shadow on the ground if asked; `samples` looks at each pixel at which the picture is not smooth, one
// at the others.
void paint_light(Image& image, const Drawing& drawing, const Camera& camera, const Style& style, int samples,
                 bool transparent, bool shadow);

}  // namespace lamella::picture
