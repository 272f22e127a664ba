// Cutting a drawing by a plane.
#pragma once

#include "picture/drawing.h"

namespace lamella::picture {

// Takes away what lies beyond the plane, which is given in the scene's coordinates. Triangles and tubes that
// cross it are cut; balls are kept or not by their centres.
void clip(Drawing& drawing, const ClippingPlane& plane);

// Vertices of no triangle go.
void drop_unused_vertices(Drawing& drawing);

}  // namespace lamella::picture
